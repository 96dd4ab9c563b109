// How good are leaves chosen at publication? Indirect light on the Lambert pixels of a camera, from pruned leaves and
// from fixed grids of linear cells that saw the same photons, against a long run of another seed on a fixed 64 x 64
// grid.
//   leaves_study truth SCENE CAMERA SECONDS TRUTH.exr
//   leaves_study table SCENE CAMERA TRUTH.exr PHOTONS...
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include "base/units.h"
#include "bins/lookup.h"
#include "engine/engine.h"
#include "image/exr.h"
#include "scene/camera.h"
#include "scene/rays.h"

namespace {

using namespace brewster;

constexpr int size = 96;   // pixels a side
constexpr int draws = 16;  // rays a pixel, on a regular 4 x 4 grid: the same points for everybody

std::vector<Hit> primary_hits(const Scene& scene, const Camera& camera) {
    const Rays rays(scene);
    std::vector<Ray> questions;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            for (int k = 0; k < draws; ++k) {
                const float px = static_cast<float>(x) + (static_cast<float>(k % 4) + 0.5f) / 4;
                const float py = static_cast<float>(y) + (static_cast<float>(k / 4) + 0.5f) / 4;
                questions.push_back({camera.position, ray_direction(camera, size, size, px, py), no_triangle});
            }
        }
    }
    std::vector<Hit> hits(questions.size());
    rays.intersect(questions, hits);
    // One looks into the room from outside through the backs of its walls.
    for (std::size_t i = 0; i < hits.size(); ++i) {
        while (!hits[i].escaped() && hits[i].chart == no_chart) {
            questions[i].leaving = hits[i].triangle;
            questions[i].origin = hits[i].position;
            rays.intersect({&questions[i], 1}, {&hits[i], 1});
        }
    }
    return hits;
}

/// Radiance by indirect light per pixel.
Image indirect_picture(const Scene& scene, const std::vector<Hit>& hits, const Snapshot& bins) {
    Image image(size, size);
    for (int band = 0; band < band_count; ++band) image.add_channel(stokes_channel(0, band));
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].chart == no_chart) continue;
        const Chart& chart = scene.charts[hits[i].chart];
        const lookup::BinValue found =
            lookup::look_up(bins, bins.charts[hits[i].chart].indirect_root, 0u, hits[i].u, hits[i].v);
        for (int band = 0; band < band_count; ++band) {
            const float factor = scene.materials[chart.material].albedo[band] / static_cast<float>(pi) / draws;
            image.channel(stokes_channel(0, band))[i / draws] += factor * found.value[band];
        }
    }
    return image;
}

/// The mean of two independent pictures, and as V0 the square of half their difference: its expectation is the variance
/// of the mean, without any model of the noise.
Image mean_of(const Image& a, const Image& b) {
    Image mean(size, size);
    for (int band = 0; band < band_count; ++band) {
        const auto& x = a.channel(stokes_channel(0, band));
        const auto& y = b.channel(stokes_channel(0, band));
        auto& value = mean.add_channel(stokes_channel(0, band));
        for (std::size_t i = 0; i < value.size(); ++i) value[i] = 0.5f * (x[i] + y[i]);
        auto& variance = mean.add_channel(variance_channel(0, band));
        for (std::size_t i = 0; i < variance.size(); ++i) variance[i] = 0.25f * (x[i] - y[i]) * (x[i] - y[i]);
    }
    return mean;
}

struct Run {
    std::shared_ptr<const Snapshot> bins;
    Progress progress;
};

Run run(const std::shared_ptr<const Scene>& scene, std::uint64_t seed, const StopRule& rule, const BinSettings& bins) {
    EngineSettings settings;
    settings.seed = seed;
    settings.bins = bins;
    Engine engine(scene, settings);
    engine.start(rule);
    engine.wait();
    return {engine.snapshot(), engine.progress()};
}

double relative_rmse(const Image& a, const Image& truth) {
    double sum = 0;
    std::size_t count = 0;
    for (int band = 0; band < band_count; ++band) {
        const auto& x = a.channel(stokes_channel(0, band));
        const auto& t = truth.channel(stokes_channel(0, band));
        const auto& v = truth.channel(variance_channel(0, band));
        double mean = 0;
        for (const float value : t) mean += static_cast<double>(value) / static_cast<double>(t.size());
        for (std::size_t i = 0; i < t.size(); ++i) {
            if (t[i] <= 0) continue;
            const double b = t[i], e = 0.01 * mean, difference = static_cast<double>(x[i]) - b;
            sum += (difference * difference - static_cast<double>(v[i])) / (b * b + e * e);
            ++count;
        }
    }
    return std::sqrt(std::max(sum, 0.0) / static_cast<double>(count));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 6) {
        std::cerr << "leaves_study truth SCENE CAMERA SECONDS TRUTH.exr | table SCENE CAMERA TRUTH.exr PHOTONS...\n";
        return 2;
    }
    const auto scene = std::make_shared<const Scene>(read_scene(argv[2]));
    const std::vector<Hit> hits = primary_hits(*scene, scene->camera(argv[3]));
    BinSettings fixed;
    fixed.join_corners = false;
    if (std::strcmp(argv[1], "truth") == 0) {
        fixed.fixed_grid_log2 = 6;
        StopRule rule;
        rule.seconds = std::atof(argv[4]) / 2;
        const Run first = run(scene, 987654321, rule, fixed), second = run(scene, 123456789, rule, fixed);
        write_exr(argv[5],
                  mean_of(indirect_picture(*scene, hits, *first.bins), indirect_picture(*scene, hits, *second.bins)));
        std::printf("truth: %.4g photons\n", static_cast<double>(first.progress.photons + second.progress.photons));
        return 0;
    }
    const Image truth = read_exr(argv[4]);
    std::printf("%10s %12s %8s %12s %12s %12s\n", "photons", "pruned", "leaves", "own corners", "16 x 16", "64 x 64");
    for (int i = 5; i < argc; ++i) {
        StopRule rule;
        rule.photons = static_cast<std::uint64_t>(std::atof(argv[i]));
        const Run pruned = run(scene, 1, rule, BinSettings{});
        std::uint64_t leaves = 0;
        for (const ChartBins& chart : pruned.bins->charts) leaves += chart.indirect_leaves;
        BinSettings own;
        own.join_corners = false;
        const Run unshared = run(scene, 1, rule, own);
        fixed.fixed_grid_log2 = 4;
        const Run coarse = run(scene, 1, rule, fixed);
        fixed.fixed_grid_log2 = 6;
        const Run fine = run(scene, 1, rule, fixed);
        const auto error = [&](const Run& r) {
            return 100 * relative_rmse(indirect_picture(*scene, hits, *r.bins), truth);
        };
        std::printf("%10.3g %10.3f %% %8llu %10.3f %% %10.3f %% %10.3f %%\n", static_cast<double>(*rule.photons),
                    error(pruned), static_cast<unsigned long long>(leaves), error(unshared), error(coarse),
                    error(fine));
        std::fflush(stdout);
    }
    return 0;
}
