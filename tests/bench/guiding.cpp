// What is guided emission worth? Light that enters bases, at fixed points of all charts, from several seeds:
//   bench_guiding SCENE (--photons N | --seconds S) [SEEDS]
// prints for plain and for guided emission the relative rms spread of the seeds about their mean, which knows nothing of
// any estimate of errors, and the share of useful photons.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bins/lookup.h"
#include "engine/engine.h"

namespace {

using namespace brewster;

constexpr std::uint32_t points = 16;  // a side of each chart

std::vector<double> light_at_points(const Scene& scene, const Snapshot& bins) {
    std::vector<double> values;
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart)
        for (std::uint32_t i = 0; i < points * points; ++i) {
            const std::uint32_t step = BREWSTER_UV_ONE / points;
            const std::uint32_t u = (i % points) * step + step / 2, v = (i / points) * step + step / 2;
            const ChartBins& at = bins.charts[chart];
            const auto direct = lookup::look_up(bins, at.direct_root, 0, u, v);
            const auto indirect = lookup::look_up(bins, at.indirect_root, 0, u, v);
            values.push_back(static_cast<double>(direct.value.y + indirect.value.y));
        }
    return values;
}

void report(const std::shared_ptr<const Scene>& scene, bool guided, const StopRule& rule, std::uint64_t seeds) {
    std::vector<double> sum, squares;
    double photons = 0, useful = 0, said = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        EngineSettings settings;
        settings.seed = seed;
        settings.guided_emission = guided;
        Engine engine(scene, settings);
        engine.start(rule);
        engine.wait();
        const std::vector<double> values = light_at_points(*scene, *engine.snapshot());
        sum.resize(values.size());
        squares.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum[i] += values[i];
            squares[i] += values[i] * values[i];
        }
        const Progress progress = engine.progress();
        photons += static_cast<double>(progress.photons);
        useful += static_cast<double>(progress.useful_photons);
        said += progress.relative_error;
    }
    const auto n = static_cast<double>(seeds);
    double spread = 0, counted = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / n;
        if (!(mean > 0)) continue;
        spread += (squares[i] / n - mean * mean) * n / (n - 1) / (mean * mean);
        ++counted;
    }
    std::printf("%-7s photons %.3g, useful %.1f %%, relative spread of seeds %.2f %%, error that is said %.2f %%\n",
                guided ? "guided" : "plain", photons / n, 100 * useful / photons, 100 * std::sqrt(spread / counted),
                100 * said / n);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return std::fprintf(stderr, "bench_guiding SCENE (--photons N | --seconds S) [SEEDS]\n"), 2;
    StopRule rule;
    if (std::strcmp(argv[2], "--photons") == 0)
        rule.photons = static_cast<std::uint64_t>(std::atof(argv[3]));
    else
        rule.seconds = std::atof(argv[3]);
    const std::uint64_t seeds = argc > 4 ? static_cast<std::uint64_t>(std::atoi(argv[4])) : 8;
    const auto scene = std::make_shared<const Scene>(read_scene(argv[1]));
    for (const bool guided : {false, true}) report(scene, guided, rule, seeds);
    return 0;
}
