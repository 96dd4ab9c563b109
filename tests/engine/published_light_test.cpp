// What a reader of the published bins sees: borders that join, and error bars that mean what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "bins/lookup.h"
#include "bins/outline.h"
#include "engine/engine.h"
#include "shared/bin_layout.h"
#include "slow.h"
#include "trace.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

std::shared_ptr<const Snapshot> solve(const std::shared_ptr<const Scene>& scene, std::uint64_t seed,
                                      std::uint64_t photons, const BinSettings& bins = {}) {
    EngineSettings settings;
    settings.threads = 2;
    settings.seed = seed;
    settings.bins = bins;
    Engine engine(scene, settings);
    trace(engine, photons);
    return engine.snapshot();
}

/// Direct and indirect light of one place, mean of the bands.
struct LightAndNoise {
    double value = 0, variance = 0;
};

LightAndNoise light_and_noise_at(const Snapshot& bins, std::uint32_t chart, std::uint32_t u, std::uint32_t v) {
    LightAndNoise light;
    for (const std::uint32_t root : {bins.charts[chart].direct_root, bins.charts[chart].indirect_root}) {
        const lookup::BinValue found = lookup::look_up(bins, root, 0u, u, v);
        const auto mean = [](const glm::vec3& bands) { return static_cast<double>(bands.x + bands.y + bands.z) / 3; };
        light.value += mean(found.value);
        light.variance += std::pow(mean(found.standard_error), 2);
    }
    return light;
}

/// Steps across all borders of the cells of one tree, relative to the brighter side, at 32 places a border.
void collect_steps(const Snapshot& bins, std::uint32_t chart, std::uint32_t root, std::vector<double>& steps) {
    const std::function<void(std::uint32_t, Box<2>)> walk = [&](std::uint32_t index, const Box<2>& box) {
        const glm::uvec2 node = bins.nodes[index];
        if ((node.y & BREWSTER_NODE_LEAF) != 0) return;
        const std::size_t axis = node.y >> BREWSTER_NODE_AXIS_SHIFT, along = 1 - axis;
        for (std::uint32_t k = 0; k < 32; ++k) {
            std::array<std::uint32_t, 2> below{}, above{};
            below[axis] = node.x - 1;
            above[axis] = node.x;
            below[along] = above[along] = box.low[along] + (box.high[along] - box.low[along]) / 64 * (2 * k + 1);
            const double a = light_and_noise_at(bins, chart, below[0], below[1]).value;
            const double b = light_and_noise_at(bins, chart, above[0], above[1]).value;
            if (std::max(a, b) > 0) steps.push_back(std::abs(a - b) / std::max(a, b));
        }
        Box<2> low = box, high = box;
        low.high[axis] = high.low[axis] = node.x;
        walk(node.y & BREWSTER_NODE_INDEX, low);
        walk((node.y & BREWSTER_NODE_INDEX) + 1, high);
    };
    walk(root, {{0, 0}, {BREWSTER_UV_ONE, BREWSTER_UV_ONE}});
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double largest_percent_of_steps(const BinSettings& settings) {
    const auto scene = rooms::read("cornell-box.gltf");
    const auto bins = solve(scene, 1, 2000000, settings);
    std::vector<double> steps;
    for (const char* wall : {"back", "left", "right"}) {  // nothing touches them but other walls at their edges
        for (const std::uint32_t chart : scene->charts_of(wall)) {
            collect_steps(*bins, chart, bins->charts[chart].direct_root, steps);
            collect_steps(*bins, chart, bins->charts[chart].indirect_root, steps);
        }
    }
    EXPECT_GT(steps.size(), 1000u);
    return quantile(steps, 0.99);
}

TEST(PublishedLight, LitWallsShowNoBorders) {
    EXPECT_LT(largest_percent_of_steps(BinSettings{}), 0.01);
}

TEST(PublishedLight, CellsOnTheirOwnWouldShowTheirBorders) {
    BinSettings settings;
    settings.join_corners = false;
    EXPECT_GT(largest_percent_of_steps(settings), 0.03);
}

/// Places in the middles of a side x side grid on every chart.
std::vector<LightAndNoise> light_of(const Scene& scene, const Snapshot& bins, std::uint32_t side) {
    std::vector<LightAndNoise> light;
    const std::uint32_t half = BREWSTER_UV_ONE / (2 * side);
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart)
        for (std::uint32_t i = 0; i < side * side; ++i)
            light.push_back(light_and_noise_at(bins, chart, (2 * (i % side) + 1) * half, (2 * (i / side) + 1) * half));
    return light;
}

/// Shares of the lit places of six seeds that lie within `widths` of their stated errors around a truth of many more
/// photons.
std::vector<double> shares_within(const std::vector<double>& widths) {
    constexpr std::uint32_t side = 32;
    const auto scene = rooms::read("cornell-box.gltf");
    const std::vector<LightAndNoise> truth = light_of(*scene, *solve(scene, 99, slow ? 500'000 : 8'000'000), side);
    const double mean = std::accumulate(truth.begin(), truth.end(), 0.0,
                                        [](double sum, const LightAndNoise& light) { return sum + light.value; }) /
                        static_cast<double>(truth.size());
    std::vector<double> within(widths.size());
    double places = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const std::vector<LightAndNoise> light = light_of(*scene, *solve(scene, seed, slow ? 20'000 : 200'000), side);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (truth[i].value < 0.1 * mean) continue;  // what boxes stand on
            const double deviations = std::abs(light[i].value - truth[i].value) / std::sqrt(light[i].variance);
            for (std::size_t k = 0; k < widths.size(); ++k) within[k] += deviations <= widths[k];
            places += 1;
        }
    }
    for (double& share : within) share /= places;
    return within;
}

// Most of the error is not noise but what cells leave out, which is known by the chart at best: bars are wide enough, and
// less than half again too wide in the middle.
TEST(PublishedLight, ErrorsLieWithinTheirBars) {
    const std::vector<double> within = shares_within({0.5, 1, 2});
    EXPECT_GT(within[1], 0.65);
    EXPECT_LT(within[1], 0.88);
    EXPECT_GT(within[2], slow ? 0.85 : 0.9);
    EXPECT_LT(within[0], 0.62);  // bars of half the length would be noticed
}

}  // namespace
}  // namespace brewster
