#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/engine.h"

/// Whether photons in blocks give the scalar engine's digest: `bench_hashes PHOTONS SCENE...`. Every scene in every kernel
/// that can hold its light's colours, windows of 256 to 8192, 1 and 2 threads, 8 lanes and as many as there are, and once
/// with a pause on the way.
namespace brewster {
namespace {

std::string digest_of(const std::shared_ptr<const Scene>& scene, const EngineSettings& settings, std::uint64_t photons,
                      bool with_pause = false) {
    Engine engine(scene, settings);
    StopRule rule;
    if (with_pause) {
        rule.photons = photons / 3 + 1;
        engine.start(rule);
        engine.wait();
    }
    rule.photons = photons;
    engine.start(rule);
    engine.wait();
    return engine.digest();
}

// How many runs differ from the scalar engine's.
int differing(const std::string& path, std::uint64_t photons) {
    const auto scene = std::make_shared<const Scene>(read_scene(path));
    const bool coloured = needs_of(*scene).bands == 3;
    std::vector<int> all_lanes = {8};
    if (widest_lanes() > 8) all_lanes.push_back(widest_lanes());
    int runs = 0, differ = 0, kernels = 0;
    for (const int stokes : {1, 3, 4})
        for (const int bands : {1, 3})
            for (const bool gloss : {false, true}) {
                if (bands == 1 && coloured) continue;
                ++kernels;
                EngineSettings settings;
                settings.kernel = KernelChoice{stokes, bands, gloss};
                settings.threads = 1;
                settings.window = 0;
                const std::string oracle = digest_of(scene, settings, photons);
                const auto compare = [&](bool with_pause) {
                    ++runs;
                    if (digest_of(scene, settings, photons, with_pause) == oracle) return;
                    ++differ;
                    std::printf("%s: stokes %d, bands %d, gloss %d, window %zu, %u threads, %d lanes DIFFER\n",
                                path.c_str(), stokes, bands, gloss, settings.window, settings.threads, settings.lanes);
                };
                for (const int lanes : all_lanes) {
                    settings.lanes = lanes;
                    for (const unsigned threads : {1u, 2u}) {
                        settings.threads = threads;
                        for (settings.window = 256; settings.window <= 8192; settings.window *= 2) compare(false);
                    }
                    settings.window = default_window;
                    compare(true);
                }
            }
    std::printf("%-24s %2d kernels, %3d runs in blocks, %d differ\n",
                std::filesystem::path(path).stem().string().c_str(), kernels, runs, differ);
    return differ;
}

}  // namespace
}  // namespace brewster

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "usage: bench_hashes PHOTONS SCENE...\n");
        return 2;
    }
    int differ = 0;
    for (int i = 2; i < count; ++i)
        differ += brewster::differing(arguments[i], static_cast<std::uint64_t>(std::stod(arguments[1])));
    return differ == 0 ? 0 : 1;
}
