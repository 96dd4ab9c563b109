#include <gtest/gtest.h>

#include <cstdio>

#include "engine/engine.h"
#include "slow.h"
#include "trace.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

std::string digest_of(const std::shared_ptr<const Scene>& scene, std::uint64_t photons, std::size_t window,
                      unsigned threads, const std::optional<KernelChoice>& kernel = {}, int lanes = widest_lanes()) {
    EngineSettings settings;
    settings.threads = threads;
    settings.window = window;
    settings.kernel = kernel;
    settings.lanes = lanes;
    Engine engine(scene, settings);
    trace(engine, photons);
    EXPECT_EQ(engine.progress().photons, photons);
    return engine.digest() + " " + std::to_string(engine.progress().rays) + " rays " +
           std::to_string(engine.progress().bounces) + " bounces " + std::to_string(engine.progress().useful_photons) +
           " useful, trouble " + std::to_string(engine.progress().trouble);
}

// The scalar engine is the oracle: trees, sums and counts of the blocks are its own, to the last bit, in eight lanes (one
// thread) and in as many as there are (two).
TEST(Blocks, AreTheScalarEngineOnEveryScene) {
    constexpr std::uint64_t some = slow ? 3000 : 60000;
    for (const char* name : {"cornell-box.gltf", "gloss-lab.gltf", "brewster-room.gltf", "metal-lab.gltf",
                             "spheres.gltf", "furnace.gltf"}) {
        const auto scene = rooms::read(name);
        const std::string oracle = digest_of(scene, some, 0, 2);
        for (const std::size_t window : {std::size_t{256}, default_window, std::size_t{8192}})
            for (const unsigned threads : {1u, 2u})
                EXPECT_EQ(digest_of(scene, some, window, threads, {}, threads == 1 ? 8 : widest_lanes()), oracle)
                    << name << " " << window << " " << threads;
        EXPECT_NE(digest_of(scene, some - 1, default_window, 2), oracle) << name;
    }
}

// Filters, panes, water, suns and lamps with a state of their own.
TEST(Blocks, AreTheScalarEngineInScenesThatTeach) {
    constexpr std::uint64_t some = slow ? 500 : 8000;
    for (const char* name : {"harpsichord-room.gltf", "shop-window.gltf", "sphere-lab.gltf", "three-polarizers.gltf",
                             "two-mirrors.gltf", "water-glare.gltf", "waveplates.gltf"}) {
        const auto scene = rooms::read(name);
        EXPECT_EQ(digest_of(scene, some, default_window, 2), digest_of(scene, some, 0, 1)) << name;
    }
}

// Corners in turn are clear, so that every surface has holes; some of them are met from behind, where nothing is filed.
TEST(Blocks, AreTheScalarEngineThroughHoles) {
    constexpr std::uint64_t some = slow ? 1000 : 10000;
    for (const char* name : {"cornell-box.gltf", "gloss-lab.gltf", "spheres.gltf"}) {
        auto riddled = std::make_shared<Scene>(*rooms::read(name));
        for (Material& material : riddled->materials) material.alpha_cutoff = 0.4f;
        riddled->vertex_colors.assign(riddled->vertices.size(), glm::vec4(1.0f));
        for (std::size_t i = 0; i < riddled->vertices.size(); i += 3) riddled->vertex_colors[i].w = 0;
        const std::string oracle = digest_of(riddled, some, 0, 1);
        for (const std::size_t window : {256u, 8192u}) EXPECT_EQ(digest_of(riddled, some, window, 2), oracle) << name;
        EXPECT_NE(digest_of(rooms::read(name), some, default_window, 2), oracle) << name;
    }
}

// In the middle of a batch, and taken up again by another engine with other blocks.
TEST(Blocks, AreTheScalarEngineSavedAndResumed) {
    constexpr std::uint64_t some = slow ? 2000 : 40000;
    const auto scene = rooms::read("gloss-lab.gltf");
    const std::string path = testing::TempDir() + "blocks_resumed.bins";
    EngineSettings settings;
    settings.threads = 2;
    Engine before(scene, settings);
    trace(before, some / 3 + 1);
    before.save(path);
    settings.window = 256;
    Engine after(scene, settings);
    after.load(SolutionReader(path));
    trace(after, some);
    settings.window = 0;
    Engine oracle(scene, settings);
    trace(oracle, some);
    EXPECT_EQ(after.digest(), oracle.digest());
    EXPECT_NE(before.digest(), oracle.digest());
    std::remove(path.c_str());
}

TEST(Blocks, AreTheScalarEngineWhateverTheirSize) {
    constexpr std::uint64_t some = slow ? 3000 : 30000;
    for (const char* name : {"metal-lab.gltf", "spheres.gltf"}) {
        const auto scene = rooms::read(name);
        const std::string oracle = digest_of(scene, some, 0, 1);
        for (const std::size_t window : {1u, 5u, 256u, 1000u, 8192u})
            for (const unsigned threads : {1u, 2u})
                EXPECT_EQ(digest_of(scene, some, window, threads), oracle) << name << " " << window << " " << threads;
    }
}

TEST(Blocks, AreTheScalarEngineInEveryKernel) {
    constexpr std::uint64_t some = slow ? 1000 : 10000;
    for (const char* name : {"gloss-lab.gltf", "spheres.gltf"}) {
        const auto scene = rooms::read(name);
        for (const int stokes : {1, 3, 4})
            for (const int bands : {1, 3})
                for (const bool gloss : {false, true}) {
                    if (bands == 1 && std::string(name) == "gloss-lab.gltf") continue;  // it has colours
                    const KernelChoice kernel{stokes, bands, gloss};
                    const std::string oracle = digest_of(scene, some, 0, 2, kernel);
                    for (const std::size_t window : {std::size_t{256}, default_window})
                        EXPECT_EQ(digest_of(scene, some, window, window == 256 ? 1 : 2, kernel,
                                            window == 256 ? 8 : widest_lanes()),
                                  oracle)
                            << name << " " << stokes << " " << bands << " " << gloss << " " << window;
                }
    }
}

}  // namespace
}  // namespace brewster
