#include "bins/hidden_structure.h"

#include <algorithm>
#include <cmath>

namespace brewster {
namespace {

/// Sums over leaves, as much as their ratio tells.
struct Pool {
    double structure = 0, noise = 0, leaves = 0;

    void add(const LeafExcess& leaf) {
        if (leaf.noise <= 0) return;
        structure += leaf.structure;
        noise += leaf.noise;
        leaves += 1;
    }
    double ratio() const { return noise > 0 ? structure / noise : 0; }
};

}  // namespace

std::vector<double> hidden_structure(std::span<const LeafExcess> leaves, std::span<const std::size_t> chart_begin) {
    constexpr double deviation = 4.5, lean_on_scene = 16, lean_on_none = 16;
    const std::size_t chart_count = chart_begin.size() - 1;
    std::vector<Pool> charts(chart_count);
    // Charts count by their leaves: a dim one has more noise than all the bright ones have structure.
    double scene_sum = 0, scene_leaves = 0;
    for (std::size_t chart = 0; chart < chart_count; ++chart) {
        for (std::size_t i = chart_begin[chart]; i < chart_begin[chart + 1]; ++i) charts[chart].add(leaves[i]);
        scene_sum += charts[chart].leaves * charts[chart].ratio();
        scene_leaves += charts[chart].leaves;
    }
    const double lean = std::min(lean_on_scene, scene_leaves);
    const double scene = scene_leaves > 0 ? scene_sum / scene_leaves : 0;
    std::vector<double> hidden(leaves.size());
    for (std::size_t chart = 0; chart < chart_count; ++chart) {
        const Pool& own = charts[chart];
        const double chance = deviation * std::sqrt(own.leaves + lean);
        const double sum = own.leaves * own.ratio() + lean * scene - chance;
        const double pooled = std::max(0.0, sum / (own.leaves + lean + lean_on_none));
        for (std::size_t i = chart_begin[chart]; i < chart_begin[chart + 1]; ++i) {
            const double ratio = leaves[i].noise > 0 ? leaves[i].structure / leaves[i].noise : 0;
            hidden[i] = (pooled + std::max(0.0, ratio - 2 * deviation)) / 2;
        }
    }
    return hidden;
}

}  // namespace brewster
