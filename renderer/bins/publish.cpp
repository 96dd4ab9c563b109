#include "bins/publish.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/check.h"
#include "bins/error_estimate.h"
#include "bins/joined_corners.h"
#include "bins/light_sums.h"
#include "bins/linear_fit.h"
#include "bins/lookup.h"
#include "shared/bin_layout.h"

namespace brewster {
namespace {

using Layout = RecordLayout<2>;
constexpr std::size_t looked_below = 5;  // levels of the tally tree under a published leaf that its error bar asks

class Publisher {
  public:
    Publisher(const BinTree<2>& tree, const EntryFields& fields, const Tally<2>* pending, std::uint64_t photons,
              glm::dvec3 flux_per_weight, const BinSettings& settings)
        : tree_(tree),
          fields_(fields),
          pending_(pending),
          photons_(photons),
          settings_(settings),
          flux_per_weight_(flux_per_weight) {}

    Snapshot run() {
        snapshot_.photons = photons_;
        snapshot_.charts.resize(tree_.chart_count());
        gather_spreads();
        snapshot_.direct_worlds = fields_.direct_worlds;
        snapshot_.indirect_worlds = fields_.indirect_worlds;
        for (int light = 0; light < 2; ++light) {
            gather_sums(fields_.field(light, 0));
            choose_leaves();
            pool_spreads();
            lay_out(light);
            // Both worlds have the same leaves, so that what differs between them is light.
            for (int world = 0; world < worlds_; ++world) {
                if (world > 0) gather_sums(fields_.field(light, world));
                fit_leaves();
                write_leaves(light, world);
            }
        }
        snapshot_.relative_error = relative_error();
        return std::move(snapshot_);
    }

  private:
    const Quanta* pending_estimate(std::uint32_t node) const {
        return pending_ && tree_.node(node).is_leaf() ? pending_->estimate(tree_.node(node).leaf()) : nullptr;
    }
    const Quanta* pending_test(std::uint32_t node) const {
        return pending_ && tree_.node(node).is_leaf() ? pending_->test(tree_.node(node).leaf()) : nullptr;
    }
    double age(std::uint32_t node) const { return static_cast<double>(photons_ - tree_.cell(node).birth); }

    void gather_spreads();
    void gather_sums(int field);
    void choose_leaves();
    void pool_spreads();
    double variance_ratio(std::uint32_t node) const;
    void lay_out(int light);
    void lay_out_node(std::uint32_t node, std::uint32_t slot);
    void fit_leaves();
    void fit_below(std::uint32_t node, const glm::dvec3& weight);
    void write_leaves(int light, int world);
    PublishedLeaf fit_leaf(std::uint32_t node, const glm::dvec3& weight) const;
    std::uint32_t locate(std::uint32_t root, std::uint32_t u, std::uint32_t v) const;
    void add_excess(std::size_t leaf, Excess& excess) const;
    double relative_error() const;

    const BinTree<2>& tree_;
    const EntryFields fields_;
    const Tally<2>* pending_;
    const std::uint64_t photons_;
    const BinSettings& settings_;
    const glm::dvec3 flux_per_weight_;
    Snapshot snapshot_;
    std::vector<Spread> spreads_;  // per node
    std::vector<LightSums> sums_;  // per node
    std::vector<bool> keep_;       // per node: its split is published
    // Per node: what its split explains beyond noise, with those of one, two .. levels below; squared density x area.
    std::vector<std::array<double, looked_below>> unresolved_;
    std::vector<std::array<double, band_count>> importance_;  // per chart
    std::vector<double> chart_ratio_;                         // per chart: pooled spread over sum w^2
    std::vector<PublishedLeaf> leaves_;                       // of the light at hand, chart after chart
    std::vector<std::uint32_t> leaf_nodes_;                   // beside them
    struct Place {
        std::uint32_t chart, u, v;
        double area;
    };
    std::vector<Place> places_;             // the middles of the leaves of the indirect light
    std::vector<std::size_t> chart_begin_;  // into leaves_, per chart and one more
    std::vector<std::uint32_t> roots_;      // of the light at hand, per chart
    std::uint32_t first_leaf_ = 0;          // the index of leaves_[0] in the snapshot
    int worlds_ = 1;                        // of the light at hand
};

// Children stand behind their parents, so a walk from the back meets them first.
void Publisher::gather_spreads() {
    spreads_.resize(tree_.node_count());
    for (auto node = static_cast<std::uint32_t>(tree_.node_count()); node-- > 0;) {
        Spread& spread = spreads_[node];
        const std::span<const Wide> own = tree_.sums(node).test;
        const Quanta* pending = pending_test(node);
        const auto value = [&](int row) {
            const auto i = static_cast<std::size_t>(row);
            return to_weight(own[i] + (pending ? pending[i] : 0));
        };
        spread.squares = value(Layout::squares);
        for (int r = 0; r < replica_count; ++r)
            spread.replicas[static_cast<std::size_t>(r)] = value(Layout::replicas + r);
        if (tree_.node(node).is_leaf()) continue;
        spread.add(spreads_[tree_.node(node).low_child()]);
        spread.add(spreads_[tree_.node(node).low_child() + 1]);
    }
}

void Publisher::gather_sums(int field) {
    sums_.resize(tree_.node_count());
    for (auto node = static_cast<std::uint32_t>(tree_.node_count()); node-- > 0;) {
        sums_[node] = read_sums(tree_.layout(), tree_.sums(node).estimate, pending_estimate(node), field);
        if (tree_.node(node).is_leaf()) continue;
        for (const std::uint32_t side : {0u, 1u}) {
            const std::uint32_t child = tree_.node(node).low_child() + side;
            add_child(sums_[node], tree_.cell(node).box, sums_[child], tree_.cell(child).box);
        }
    }
}

void Publisher::choose_leaves() {
    keep_.assign(tree_.node_count(), settings_.fixed_grid_log2 >= 0);
    unresolved_.assign(tree_.node_count(), {});
    // Bands count by their relative error, so that a dim band is not drowned by a bright one.
    importance_.resize(tree_.chart_count());
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        for (std::size_t b = 0; b < band_count; ++b) {
            const double mean = sums_[chart].weight[b] / age(chart);
            importance_[chart][b] = mean > 0 ? 1 / (mean * mean) : 0;
        }
    }
    if (settings_.fixed_grid_log2 >= 0) return;
    std::vector<double> gain(tree_.node_count(), 0.0);
    for (auto node = static_cast<std::uint32_t>(tree_.node_count()); node-- > 0;) {
        if (tree_.node(node).is_leaf()) continue;
        const std::uint32_t low = tree_.node(node).low_child(), high = low + 1;
        const double time = age(low);
        if (time <= 0) continue;
        LightSums later;  // what came since the split, seen by the parent
        for (const std::uint32_t child : {low, high})
            add_child(later, tree_.cell(node).box, sums_[child], tree_.cell(child).box);
        if (!later.any()) continue;
        const LinearFit parent(tree_.cell(node).geometry);
        const LinearFit fits[2] = {LinearFit(tree_.cell(low).geometry), LinearFit(tree_.cell(high).geometry)};
        double detail = 0, noise = 0;
        for (std::size_t b = 0; b < band_count; ++b) {
            // Per photon since the split, so that all noise weighs alike and young splits count by what they have seen.
            const double band = importance_[tree_.cell(node).chart][b] / time;
            double energy = -parent.energy(later.weight[b], later.moments[b]);
            double variance = -later.squares[b] / tree_.cell(node).geometry.area;
            for (const std::uint32_t side : {0u, 1u}) {
                const LightSums& child = sums_[low + side];
                energy += fits[side].energy(child.weight[b], child.moments[b]);
                variance += child.squares[b] / tree_.cell(low + side).geometry.area;
            }
            detail += band * energy;
            noise += band * 3 * variance;
        }
        if (2 * time >= static_cast<double>(photons_)) {
            std::array<double, looked_below>& below = unresolved_[node];
            below.fill((detail - noise) / time);
            for (std::size_t level = 1; level < looked_below; ++level)
                below[level] += unresolved_[low][level - 1] + unresolved_[high][level - 1];
        }
        const double net = detail + gain[low] + gain[high] - 2 * settings_.prune_lambda * noise;
        if (net > 0) {
            gain[node] = net;
            keep_[node] = true;
        }
    }
}

/// Stratified emission makes sum w^2 too large, paths that come back make it too small; the spread of the replicas says
/// by how much. One leaf alone knows it with seven degrees of freedom, so it leans on its chart, and that on the scene.
void Publisher::pool_spreads() {
    std::vector<double> variance(tree_.chart_count()), squares(tree_.chart_count()), leaves(tree_.chart_count());
    std::vector<std::uint32_t> open;
    double scene_variance = 0, scene_squares = 0;
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        open.assign(1, chart);
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            if (!tree_.node(node).is_leaf() && keep_[node]) {
                open.push_back(tree_.node(node).low_child());
                open.push_back(tree_.node(node).low_child() + 1);
                continue;
            }
            variance[chart] += spreads_[node].variance();
            squares[chart] += spreads_[node].squares;
            leaves[chart] += 1;
        }
        scene_variance += variance[chart];
        scene_squares += squares[chart];
    }
    constexpr double lean_on_scene = 4;  // leaves
    const double scene_ratio = scene_squares > 0 ? scene_variance / scene_squares : 1;
    chart_ratio_.resize(tree_.chart_count());
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        const double own = squares[chart] > 0 ? variance[chart] / squares[chart] : scene_ratio;
        chart_ratio_[chart] = (leaves[chart] * own + lean_on_scene * scene_ratio) / (leaves[chart] + lean_on_scene);
    }
}

double Publisher::variance_ratio(std::uint32_t node) const {
    constexpr double lean_on_chart = 8;  // leaves
    const double chart = chart_ratio_[tree_.cell(node).chart];
    if (spreads_[node].squares <= 0) return chart;
    return (spreads_[node].variance() / spreads_[node].squares + lean_on_chart * chart) / (1 + lean_on_chart);
}

/// `weight`: the cell's share of all weight emitted, per photon.
PublishedLeaf Publisher::fit_leaf(std::uint32_t node, const glm::dvec3& weight) const {
    const Cell<2>& cell = tree_.cell(node);
    const LightSums& sums = sums_[node];
    const LinearFit fit(cell.geometry);
    const double ratio = variance_ratio(node);
    PublishedLeaf leaf;
    leaf.box = cell.box;
    leaf.geometry = &cell.geometry;
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        leaf.density[band] = flux_per_weight_[band] * weight[band] / cell.geometry.area;
        const auto slope = fit.slope(sums.weight[b], sums.moments[b]);
        // On a full cell the fit must not fall below zero in a corner.
        const double steepest = std::abs(slope[0]) + std::abs(slope[1]);
        const double limit = cell.geometry.full && steepest > 1 ? 1 / steepest : 1;
        for (std::size_t a = 0; a < 2; ++a) leaf.slopes[a][band] = leaf.density[band] * slope[a] * limit;
        if (sums.weight[b] > 0) {
            leaf.standard_error[band] = leaf.density[band] * std::sqrt(ratio * sums.squares[b]) / sums.weight[b];
        } else {
            // Nothing landed here: not known better than one photon of the chart's mean weight.
            const LightSums& chart = sums_[cell.chart];
            const double one = chart.weight[b] > 0 ? chart.squares[b] / chart.weight[b] : 0;
            leaf.standard_error[band] =
                age(node) > 0 ? flux_per_weight_[band] * one / (age(node) * cell.geometry.area) : 0;
        }
    }
    return leaf;
}

void Publisher::lay_out(int light) {
    worlds_ = fields_.worlds(light);
    first_leaf_ = static_cast<std::uint32_t>(snapshot_.leaves.size() / BREWSTER_LEAF_TEXELS);
    leaf_nodes_.clear();
    roots_.clear();
    chart_begin_.assign(1, 0);
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        const auto root = static_cast<std::uint32_t>(snapshot_.nodes.size());
        snapshot_.nodes.emplace_back();
        lay_out_node(chart, root);
        roots_.push_back(root);
        chart_begin_.push_back(leaf_nodes_.size());
        ChartBins& bins = snapshot_.charts[chart];
        (light == 0 ? bins.direct_root : bins.indirect_root) = root;
        (light == 0 ? bins.direct_leaves : bins.indirect_leaves) =
            static_cast<std::uint32_t>(chart_begin_[chart + 1] - chart_begin_[chart]);
    }
    snapshot_.leaves.resize(snapshot_.leaves.size() +
                            leaf_nodes_.size() * static_cast<std::size_t>(worlds_) * BREWSTER_LEAF_TEXELS);
}

// Writes the node at `slot` of the snapshot and all below it.
void Publisher::lay_out_node(std::uint32_t node, std::uint32_t slot) {
    const TreeNode& tree_node = tree_.node(node);
    if (tree_node.is_leaf() || !keep_[node]) {
        const auto index =
            first_leaf_ + static_cast<std::uint32_t>(leaf_nodes_.size()) * static_cast<std::uint32_t>(worlds_);
        snapshot_.nodes[slot] = {0u, BREWSTER_NODE_LEAF | index};
        leaf_nodes_.push_back(node);
        return;
    }
    const std::uint32_t low = tree_node.low_child();
    const auto child_slot = static_cast<std::uint32_t>(snapshot_.nodes.size());
    snapshot_.nodes.resize(child_slot + 2);
    snapshot_.nodes[slot] = {tree_node.split, tree_node.axis() << BREWSTER_NODE_AXIS_SHIFT | child_slot};
    for (const std::uint32_t side : {0u, 1u}) lay_out_node(low + side, child_slot + side);
}

// In the order of lay_out.
void Publisher::fit_leaves() {
    leaves_.clear();
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        const auto& total = sums_[chart].weight;
        const std::size_t begin = leaves_.size();
        fit_below(chart, glm::dvec3(total[0], total[1], total[2]) / age(chart));
        const std::span<PublishedLeaf> own(leaves_.begin() + static_cast<std::ptrdiff_t>(begin), leaves_.end());
        if (settings_.join_corners) {
            join_corners(own, [&](std::uint32_t u, std::uint32_t v) {
                return locate(roots_[chart], u, v) - static_cast<std::uint32_t>(begin);
            });
        } else {
            keep_own_corners(own);
        }
    }
}

void Publisher::fit_below(std::uint32_t node, const glm::dvec3& weight) {
    const TreeNode& tree_node = tree_.node(node);
    if (tree_node.is_leaf() || !keep_[node]) {
        leaves_.push_back(fit_leaf(node, weight));
        return;
    }
    const std::uint32_t low = tree_node.low_child();
    glm::dvec3 shares[2];
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const double together = sums_[low].weight[b] + sums_[low + 1].weight[b];
        const double areas = tree_.cell(low).geometry.area + tree_.cell(low + 1).geometry.area;
        for (const std::uint32_t side : {0u, 1u}) {
            shares[side][band] =
                together > 0 ? sums_[low + side].weight[b] / together : tree_.cell(low + side).geometry.area / areas;
        }
    }
    for (const std::uint32_t side : {0u, 1u}) fit_below(low + side, weight * shares[side]);
}

std::uint32_t Publisher::locate(std::uint32_t root, std::uint32_t u, std::uint32_t v) const {
    glm::uvec2 node = snapshot_.nodes[root];
    while ((node.y & BREWSTER_NODE_LEAF) == 0) {
        const std::uint32_t x = (node.y >> BREWSTER_NODE_AXIS_SHIFT) == 0 ? u : v;
        node = snapshot_.nodes[(node.y & BREWSTER_NODE_INDEX) + (x < node.x ? 0u : 1u)];
    }
    return ((node.y & ~BREWSTER_NODE_LEAF) - first_leaf_) / static_cast<std::uint32_t>(worlds_);
}

void Publisher::add_excess(std::size_t leaf, Excess& excess) const {
    const std::uint32_t node = leaf_nodes_[leaf];
    const double time = age(node);
    if (time <= 0) return;
    excess.structure += unresolved_[node][looked_below - 1];
    for (std::size_t b = 0; b < band_count; ++b) {
        excess.noise += importance_[tree_.cell(node).chart][b] * leaves_[leaf].freedom * sums_[node].squares[b] /
                        (tree_.cell(node).geometry.area * time * time);
    }
    excess.leaves += 1;
}

void Publisher::write_leaves(int light, int world) {
    Excess scene;
    for (std::size_t i = 0; i < leaves_.size(); ++i) add_excess(i, scene);
    for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
        Excess excess;
        for (std::size_t i = chart_begin_[chart]; i < chart_begin_[chart + 1]; ++i) add_excess(i, excess);
        const double inflation = excess.inflation(scene);
        for (std::size_t i = chart_begin_[chart]; i < chart_begin_[chart + 1]; ++i) {
            const PublishedLeaf& leaf = leaves_[i];
            const glm::dvec3 error = std::sqrt(leaf.freedom * inflation) * leaf.standard_error;
            glm::vec4* texels =
                &snapshot_.leaves[BREWSTER_LEAF_TEXELS * (first_leaf_ + i * static_cast<std::size_t>(worlds_) +
                                                          static_cast<std::size_t>(world))];
            for (int corner = 0; corner < 4; ++corner) {
                texels[corner] = {glm::vec3(leaf.corners[static_cast<std::size_t>(corner)]),
                                  corner < 3 ? static_cast<float>(error[corner]) : 0.0f};
            }
            if (light == 0 || world > 0) continue;
            const auto middle = [&](std::size_t a) {
                return leaf.box.low[a] + (leaf.box.high[a] - leaf.box.low[a]) / 2;
            };
            places_.push_back({chart, middle(0), middle(1), leaf.geometry->area});
        }
    }
}

/// Area-weighted rms of standard error over value, of the band mean of direct and indirect light together; values below
/// 1 % of the scene's mean count as that, so that black corners do not rule.
double Publisher::relative_error() const {
    std::vector<glm::dvec2> values;  // value, standard error
    double mean = 0, area = 0;
    for (const Place& place : places_) {
        const ChartBins& bins = snapshot_.charts[place.chart];
        glm::dvec2 sum(0);
        for (const std::uint32_t root : {bins.direct_root, bins.indirect_root}) {
            const lookup::BinValue found = lookup::look_up(snapshot_, root, 0u, place.u, place.v);
            const double error = (found.standard_error.x + found.standard_error.y + found.standard_error.z) / 3.0;
            sum.x += (found.value.x + found.value.y + found.value.z) / 3.0;
            sum.y += error * error;
        }
        values.push_back(sum);
        mean += place.area * sum.x;
        area += place.area;
    }
    const double least = 0.01 * mean / area;
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = std::max(values[i].x, least);
        if (value > 0) squares += places_[i].area * values[i].y / (value * value);
    }
    return std::sqrt(squares / area);
}

}  // namespace

Snapshot publish(const BinTree<2>& tree, const EntryFields& fields, const Tally<2>* pending, std::uint64_t photons,
                 glm::dvec3 flux_per_weight, const BinSettings& settings) {
    BREWSTER_CHECK(photons > 0, "nothing to publish before the first photon");
    BREWSTER_CHECK(tree.layout() == fields.layout(), "the tree keeps other fields");
    return Publisher(tree, fields, pending, photons, flux_per_weight, settings).run();
}

}  // namespace brewster
