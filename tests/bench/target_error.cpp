// Does --target-error stop at the error that it promises?
//   bench_target_error SCENE TARGET TRUTH_PHOTONS [SEEDS]
// prints for each seed the photons it took and the true error, the area-weighted rms of the relative difference of the
// light on all walls from that of so many photons of other seeds, and in the end their root mean square over the target.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bin_error.h"
#include "engine/engine.h"

namespace {

using namespace brewster;

BinLight solved(const std::shared_ptr<const Scene>& scene, std::uint64_t seed, const StopRule& rule,
                Progress& progress) {
    EngineSettings settings;
    settings.seed = seed;
    settings.threads = 2;
    Engine engine(scene, settings);
    engine.start(rule);
    engine.wait();
    progress = engine.progress();
    return light_of(*scene, *engine.snapshot());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return std::fprintf(stderr, "bench_target_error SCENE TARGET TRUTH_PHOTONS [SEEDS]\n"), 2;
    const double target = std::atof(argv[2]);
    const int seeds = argc > 4 ? std::atoi(argv[4]) : 32;
    const auto scene = std::make_shared<const Scene>(read_scene(argv[1]));
    Progress progress;
    const BinLight truth = solved(scene, 1000, {static_cast<std::uint64_t>(std::atof(argv[3])), {}, {}}, progress);
    double squares = 0, photons = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const BinLight light = solved(scene, static_cast<std::uint64_t>(seed), {{}, {}, target}, progress);
        const double error = relative_error_of(light, truth);
        std::printf("seed %d: %.3g photons, said %.4f, true %.4f\n", seed, static_cast<double>(progress.photons),
                    progress.relative_error, error);
        squares += error * error / seeds;
        photons += static_cast<double>(progress.photons) / seeds;
    }
    std::printf("%s: target %.4f, %.3g photons, true error over target %.3f\n", scene->name.c_str(), target, photons,
                std::sqrt(squares) / target);
    return 0;
}
