#include "display/picture.h"

#include <benchmark/benchmark.h>

#include <random>

#include "display/osmesa_context.h"
#include "shared/bin_layout.h"

namespace {

using namespace brewster;

/// A tree of 2^depth leaves, split in turns along u and v, with random values.
std::uint32_t add_tree(Snapshot& bins, std::uint32_t place, std::array<std::uint32_t, 4> cell, int depth,
                       std::mt19937& random) {
    if (depth == 0) {
        bins.nodes[place] = {
            0u, BREWSTER_NODE_LEAF | static_cast<std::uint32_t>(bins.leaves.size() / BREWSTER_LEAF_TEXELS)};
        for (unsigned k = 0; k < BREWSTER_LEAF_TEXELS; ++k) {
            bins.leaves.emplace_back(std::uniform_real_distribution(0.0f, 1.0f)(random));
        }
        return place;
    }
    const std::uint32_t axis = static_cast<std::uint32_t>(depth) % 2;
    const std::uint32_t split = (cell[2 * axis] + cell[2 * axis + 1]) / 2;
    const auto child = static_cast<std::uint32_t>(bins.nodes.size());
    bins.nodes.resize(bins.nodes.size() + 2);
    bins.nodes[place] = {split, axis << BREWSTER_NODE_AXIS_SHIFT | child};
    std::array<std::uint32_t, 4> low = cell, high = cell;
    low[2 * axis + 1] = split;
    high[2 * axis] = split;
    add_tree(bins, child, low, depth - 1, random);
    add_tree(bins, child + 1, high, depth - 1, random);
    return place;
}

/// One jittered draw at 1280 x 720 and its share of the sums; the walls of the box fill the picture, each with a tree
/// of direct and one of indirect light. The processor time counts all threads of the driver.
void draw_cornell_box(benchmark::State& state) {
    const OsmesaContext context;
    const Scene scene = read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf");
    auto bins = std::make_shared<Snapshot>();
    std::mt19937 random(1);
    const int depth = static_cast<int>(state.range(0));
    for (std::size_t i = 0; i < scene.charts.size(); ++i) {
        const auto tree = [&] {
            bins->nodes.emplace_back();
            return add_tree(*bins, static_cast<std::uint32_t>(bins->nodes.size() - 1),
                            {0, BREWSTER_UV_ONE, 0, BREWSTER_UV_ONE}, depth, random);
        };
        ChartBins chart;
        chart.direct_root = tree();
        chart.indirect_root = tree();
        bins->charts.push_back(chart);
    }
    Picture picture(scene);
    picture.show(bins);
    picture.upload();
    picture.look(scene.camera("inside"), 1280, 720);
    picture.draw();
    for (auto _ : state) {
        picture.draw();
        picture.finish();
    }
    state.counters["leaves"] = static_cast<double>(bins->leaves.size() / BREWSTER_LEAF_TEXELS);
}
BENCHMARK(draw_cornell_box)
    ->DenseRange(0, 12, 3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
