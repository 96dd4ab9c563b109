#include "bins/pruning.h"

#include <algorithm>

#include "bins/half_difference.h"
#include "bins/split_test.h"

namespace brewster {

template <int D>
Pruning<D>::Pruning(const BinTree<D>& tree, const Tally<D>* pending, std::uint64_t photons, const BinSettings& settings,
                    unsigned threads)
    : tree_(tree), pending_(pending), photons_(photons), settings_(settings), threads_(threads), nodes_(tree, threads) {
    gather_spreads();
    if (asks_tests) pool_tally_spreads();
}

template <int D>
bool Pruning<D>::is_pending(std::uint32_t node) const {
    return pending_ && tree_.node(node).is_leaf() && pending_->touched(tree_.node(node).leaf());
}

// Rows of the node's own test record, the running batch's included.
template <int D>
auto Pruning<D>::test_of(std::uint32_t node) const {
    return [own = tree_.sums(node).test,
            pending = is_pending(node) ? pending_->test(tree_.node(node).leaf()) : nullptr](int row) {
        const auto i = static_cast<std::size_t>(row);
        return to_weight(own[i] + (pending ? pending[i] : 0));
    };
}

template <int D>
void Pruning<D>::gather_spreads() {
    using Layout = RecordLayout<D>;
    spreads_.resize(tree_.node_count());
    nodes_.visit([&](std::uint32_t node) {
        Spread& spread = spreads_[node];
        const auto value = test_of(node);
        spread.squares = value(Layout::squares);
        for (int r = 0; r < replica_count; ++r)
            spread.replicas[static_cast<std::size_t>(r)] = value(Layout::replicas + r);
        if (tree_.node(node).is_leaf()) return;
        spread.add(spreads_[tree_.node(node).low_child()]);
        spread.add(spreads_[tree_.node(node).low_child() + 1]);
    });
}

template <int D>
void Pruning<D>::pool_tally_spreads() {
    std::vector<double> variance(tree_.chart_count()), squares(tree_.chart_count());
    for (std::uint32_t node = 0; node < tree_.node_count(); ++node) {
        if (!tree_.node(node).is_leaf()) continue;
        variance[tree_.cell(node).chart] += spreads_[node].variance();
        squares[tree_.cell(node).chart] += spreads_[node].squares;
    }
    tally_ratio_.resize(tree_.chart_count());
    for (std::size_t chart = 0; chart < tally_ratio_.size(); ++chart)
        tally_ratio_[chart] = squares[chart] > 0 ? variance[chart] / squares[chart] : 1;
}

// What the node's test saw beyond a linear fit, less its noise, while it was a leaf. It knows the band mean; all bands are
// taken to have that structure relative to their light.
template <int D>
double Pruning<D>::misfit(std::uint32_t node, const FieldSums<D>& sums) const {
    const TreeNode& tree_node = tree_.node(node);
    const Cell<D>& cell = tree_.cell(node);
    const std::uint64_t end = tree_node.is_leaf() ? photons_ : tree_.cell(tree_node.low_child()).birth;
    const auto time = static_cast<double>(end - cell.birth);
    if (time <= 0) return 0;
    const auto sum = test_of(node);
    double weight = 0, light = 0, relative = 0;
    for (int r = 0; r < replica_count; ++r) weight += sum(RecordLayout<D>::replicas + r);
    for (std::size_t b = 0; b < band_count; ++b) {
        light += sums.weight[b] / age(node) / band_count;
        relative += importance_[cell.chart][b] * sums.weight[b] * sums.weight[b] / (age(node) * age(node));
    }
    if (light <= 0) return 0;
    const Deviations<D> found(sum, weight, null_moments<D>(cell.geometry));
    const double noise = Deviations<D>::functions * tally_ratio_[cell.chart] * sum(RecordLayout<D>::squares);
    return (found.energy() - noise) / (cell_measure(cell) * time * time) * relative / (light * light);
}

template <int D>
void Pruning<D>::sum_up(int field, NodeSums<D>& sums) const {
    sums.resize(tree_.node_count());
    nodes_.visit([&](std::uint32_t node) {
        const Quanta* const pending = is_pending(node) ? pending_->estimate(tree_.node(node).leaf()) : nullptr;
        sums[node] = read_sums<D>(tree_.layout(), tree_.sums(node).estimate, pending, field);
        if (tree_.node(node).is_leaf()) return;
        for (const std::uint32_t side : {0u, 1u}) {
            const std::uint32_t child = tree_.node(node).low_child() + side;
            add_child<D>(sums[node], tree_.cell(node).box, sums[child], tree_.cell(child).box);
        }
    });
}

// Of what came since the split, so that young splits count by what they saw; per photon, so that all noise weighs the
// same.
template <int D>
auto Pruning<D>::evidence(std::uint32_t node, const Fields& fields) const -> Evidence {
    const std::uint32_t low = tree_.node(node).low_child(), high = low + 1;
    const double time = age(low);
    Evidence found;
    if (time <= 0) return found;
    const int freedom = settings_.constant_cells ? 1 : D + 1;
    const auto energy_of = [&](const LinearFit<D>& fit, double weight, const std::array<double, D>& moments) {
        return settings_.constant_cells ? weight * weight / fit.measure() : fit.energy(weight, moments);
    };
    const Cell<D>& cell = tree_.cell(node);
    const LinearFit<D> parent(cell);
    const LinearFit<D> fits[2] = {LinearFit<D>(tree_.cell(low)), LinearFit<D>(tree_.cell(high))};
    for (const NodeSums<D>* field : fields) {
        FieldSums<D> later;  // what came since the split, seen by the parent
        for (const std::uint32_t child : {low, high})
            add_child<D>(later, cell.box, (*field)[child], tree_.cell(child).box);
        if (!later.any()) continue;
        found.any = true;
        for (std::size_t b = 0; b < band_count; ++b) {
            const double band = importance_[cell.chart][b] / time;
            double energy = -energy_of(parent, later.weight[b], later.moments[b]);
            double variance = -later.squares[b] / parent.measure();
            for (const std::uint32_t side : {0u, 1u}) {
                const FieldSums<D>& child = (*field)[low + side];
                energy += energy_of(fits[side], child.weight[b], child.moments[b]);
                variance += child.squares[b] / fits[side].measure();
            }
            found.detail += band * energy;
            found.noise += band * freedom * variance;
        }
        if (field == fields.front()) {
            found.first_detail = found.detail;
            found.first_noise = found.noise;
        }
    }
    return found;
}

template <int D>
void Pruning<D>::choose(const Fields& fields) {
    keep_.resize(tree_.node_count());
    unresolved_.resize(tree_.node_count());
    gain_.resize(tree_.node_count());
    // Bands count by their relative error, so that a dim band is not drowned by a bright one.
    importance_.resize(tree_.chart_count());
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        for (std::size_t b = 0; b < band_count; ++b) {
            const double mean = (*fields[0])[chart].weight[b] / age(chart);
            importance_[chart][b] = mean > 0 ? 1 / (mean * mean) : 0;
        }
    }
    nodes_.visit([&](std::uint32_t node) {
        keep_[node] = 0;
        unresolved_[node] = {};
        gain_[node] = 0;
        const bool is_leaf = tree_.node(node).is_leaf();
        if (settings_.fixed_grid_log2 >= 0) {
            if (!is_leaf) keep_[node] = 1;
            return;
        }
        const std::uint32_t low = tree_.node(node).low_child(), high = low + 1;
        const double time = is_leaf ? 0 : age(low);
        const bool is_young = 2 * time < static_cast<double>(photons_);
        if (asks_tests && is_young) unresolved_[node].fill(misfit(node, (*fields[0])[node]));
        if (time <= 0) return;
        if (settings_.half_differences) {
            keep_[node] = halves_are_known((*fields[0])[low], (*fields[0])[high]) ? 1 : 0;
            return;
        }
        const Evidence found = evidence(node, fields);
        if (!found.any) return;
        if (!is_young) {
            std::array<double, looked_below>& below = unresolved_[node];
            // Stratified photons: all of the small noise is taken off, no more, or it would hide the structure.
            const double squares = spreads_[low].squares + spreads_[high].squares;
            const double ratio = squares > 0 ? (spreads_[low].variance() + spreads_[high].variance()) / squares : 1;
            below.fill((found.first_detail - ratio * found.first_noise) / time);
            for (std::size_t level = 1; level < looked_below; ++level)
                below[level] += unresolved_[low][level - 1] + unresolved_[high][level - 1];
        }
        const double net = found.detail + gain_[low] + gain_[high] - 2 * settings_.prune_lambda * found.noise;
        if (net > 0) {
            gain_[node] = net;
            keep_[node] = 1;
        }
    });
    if (refines && settings_.fixed_grid_log2 < 0 && !settings_.half_differences) refine(fields);
    pool_spreads();
}

// Under each leaf of the pruned tree that has a published split above it.
template <int D>
void Pruning<D>::refine(const Fields& fields) {
    over_ranges(tree_.chart_count(), 1, threads_, [&](std::size_t chart, std::size_t) {
        const auto root = static_cast<std::uint32_t>(chart);
        std::vector<std::uint32_t> splits;
        if (!is_published_leaf(root)) splits.push_back(root);
        while (!splits.empty()) {
            const std::uint32_t low = tree_.node(splits.back()).low_child();
            splits.pop_back();
            for (const std::uint32_t child : {low, low + 1}) {
                if (is_published_leaf(child))
                    gain_near(child, near_levels, fields);
                else
                    splits.push_back(child);
            }
        }
    });
}

// What publishing the splits from here on gains, `levels` of them by the smaller lambda. Keeps those that gain.
template <int D>
double Pruning<D>::gain_near(std::uint32_t node, int levels, const Fields& fields) {
    if (tree_.node(node).is_leaf()) return 0;
    if (levels == 0) return gain_[node];
    const Evidence found = evidence(node, fields);
    if (!found.any) return 0;
    const std::uint32_t low = tree_.node(node).low_child();
    const double net = found.detail + gain_near(low, levels - 1, fields) + gain_near(low + 1, levels - 1, fields) -
                       2 * near_lambda * found.noise;
    keep_[node] = net > 0 ? 1 : 0;
    return std::max(net, 0.0);
}

template <int D>
void Pruning<D>::pool_spreads() {
    const std::size_t charts = tree_.chart_count();
    std::vector<double> variance(charts), squares(charts), leaves(charts);
    over_ranges(charts, 1, threads_, [&](std::size_t chart, std::size_t) {
        std::vector<std::uint32_t> open(1, static_cast<std::uint32_t>(chart));
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            if (!is_published_leaf(node)) {
                open.push_back(tree_.node(node).low_child());
                open.push_back(tree_.node(node).low_child() + 1);
                continue;
            }
            variance[chart] += spreads_[node].variance();
            squares[chart] += spreads_[node].squares;
            leaves[chart] += 1;
        }
    });
    double scene_variance = 0, scene_squares = 0;
    for (std::size_t chart = 0; chart < charts; ++chart) {
        scene_variance += variance[chart];
        scene_squares += squares[chart];
    }
    constexpr double lean_on_scene = 4;  // leaves
    const double scene_ratio = scene_squares > 0 ? scene_variance / scene_squares : 1;
    chart_ratio_.resize(charts);
    for (std::size_t chart = 0; chart < charts; ++chart) {
        const double own = squares[chart] > 0 ? variance[chart] / squares[chart] : scene_ratio;
        chart_ratio_[chart] = (leaves[chart] * own + lean_on_scene * scene_ratio) / (leaves[chart] + lean_on_scene);
    }
}

template <int D>
double Pruning<D>::variance_ratio(std::uint32_t node) const {
    constexpr double lean_on_chart = 8;  // leaves
    const double chart = chart_ratio_[tree_.cell(node).chart];
    if (spreads_[node].squares <= 0) return chart;
    return (spreads_[node].variance() / spreads_[node].squares + lean_on_chart * chart) / (1 + lean_on_chart);
}

template <int D>
LeafExcess Pruning<D>::excess(std::uint32_t node, const FieldSums<D>& sums, double freedom) const {
    LeafExcess excess;
    const double time = age(node);
    if (time <= 0) return excess;
    excess.structure = unresolved_[node][looked_below - 1];
    for (std::size_t b = 0; b < band_count; ++b) {
        excess.noise += importance_[tree_.cell(node).chart][b] * freedom * sums.squares[b] /
                        (cell_measure(tree_.cell(node)) * time * time);
    }
    return excess;
}

template class Pruning<2>;
template class Pruning<4>;

}  // namespace brewster
