#include <gtest/gtest.h>

#include "engine/engine.h"
#include "slow.h"
#include "trace.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

std::string digest_of(const std::shared_ptr<const Scene>& scene, std::uint64_t photons, std::size_t window,
                      unsigned threads, const std::optional<KernelChoice>& kernel = {}) {
    EngineSettings settings;
    settings.threads = threads;
    settings.window = window;
    settings.kernel = kernel;
    Engine engine(scene, settings);
    trace(engine, photons);
    EXPECT_EQ(engine.progress().photons, photons);
    return engine.digest() + " " + std::to_string(engine.progress().rays) + " rays " +
           std::to_string(engine.progress().bounces) + " bounces " + std::to_string(engine.progress().useful_photons) +
           " useful, trouble " + std::to_string(engine.progress().trouble);
}

// The scalar engine is the oracle: trees, sums and counts of the blocks are its own, to the last bit.
TEST(Blocks, AreTheScalarEngineOnEveryScene) {
    constexpr std::uint64_t some = slow ? 3000 : 60000;
    for (const char* name : {"cornell-box.gltf", "gloss-lab.gltf", "brewster-room.gltf", "metal-lab.gltf",
                             "spheres.gltf", "furnace.gltf"}) {
        const auto scene = rooms::read(name);
        const std::string oracle = digest_of(scene, some, 0, 2);
        EXPECT_EQ(digest_of(scene, some, default_window, 2), oracle) << name;
        EXPECT_NE(digest_of(scene, some - 1, default_window, 2), oracle) << name;
    }
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
                    EXPECT_EQ(digest_of(scene, some, default_window, 2, kernel), digest_of(scene, some, 0, 2, kernel))
                        << name << " " << stokes << " " << bands << " " << gloss;
                }
    }
}

}  // namespace
}  // namespace brewster
