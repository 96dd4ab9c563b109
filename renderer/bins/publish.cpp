#include "bins/publish.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <span>
#include <utility>

#include "base/check.h"
#include "base/threads.h"
#include "bins/joined_corners.h"
#include "bins/lookup.h"
#include "bins/pruning.h"
#include "shared/bin_layout.h"

namespace brewster {
namespace {

constexpr std::size_t leaves_at_a_time = 1024;

// Of the published function, rms over the cell. Where neighbours share corners, what they make of the cell's fit is off
// from it by noise, of known size, and by light that is not linear, of which the shared function then misses about as
// much. Where it has its corners to itself, the tally tree below must tell (`hidden`, in variances of its own).
glm::dvec3 error_of(const PublishedLeaf& leaf, double hidden) {
    const glm::dvec3 variance = leaf.standard_error * leaf.standard_error;
    const double alone = std::clamp((leaf.freedom - 1) / 2, 0.0, 1.0);
    const glm::dvec3 structure = glm::max(glm::dvec3(0), leaf.bend - (3 - leaf.freedom) * variance);
    return glm::sqrt(leaf.freedom * (1 + alone * hidden) * variance + structure);
}

class Publisher {
  public:
    Publisher(const BinTree<2>& tree, const EntryFields& fields, const Tally<2>* pending, std::uint64_t photons,
              glm::dvec3 flux_per_weight, const BinSettings& settings, unsigned threads)
        : tree_(tree),
          fields_(fields),
          pruning_(tree, pending, photons, settings, threads),
          photons_(photons),
          settings_(settings),
          flux_per_weight_(flux_per_weight),
          threads_(threads) {}

    Snapshot run() {
        snapshot_.photons = photons_;
        snapshot_.charts.resize(tree_.chart_count());
        snapshot_.direct_worlds = fields_.direct_worlds;
        snapshot_.indirect_worlds = fields_.indirect_worlds;
        for (int light = 0; light < 2; ++light) {
            pruning_.sum_up(fields_.field(light, 0), sums_);
            pruning_.choose({&sums_});
            lay_out(light);
            // Both worlds have the same leaves, so that what differs between them is light.
            for (int world = 0; world < worlds_; ++world) {
                if (world > 0) pruning_.sum_up(fields_.field(light, world), sums_);
                fit_leaves();
                write_leaves(light, world);
            }
        }
        snapshot_.relative_error = relative_error();
        return std::move(snapshot_);
    }

  private:
    void lay_out(int light);
    void lay_out_node(std::uint32_t node, std::uint32_t slot);
    void fit_leaves();
    void fit_below(std::uint32_t node, const glm::dvec3& weight, std::size_t& next);
    void write_leaves(int light, int world);
    PublishedLeaf fit_leaf(std::uint32_t node, const glm::dvec3& weight) const;
    std::uint32_t locate(std::uint32_t root, std::uint32_t u, std::uint32_t v) const;
    double darkest_lit(const std::vector<glm::dvec2>& values, double area) const;
    double relative_error() const;

    const BinTree<2>& tree_;
    const EntryFields fields_;
    Pruning<2> pruning_;
    const std::uint64_t photons_;
    const BinSettings& settings_;
    const glm::dvec3 flux_per_weight_;
    const unsigned threads_;
    Snapshot snapshot_;
    NodeSums<2> sums_;                       // of the light and world at hand
    ZeroedArray<PublishedLeaf> leaves_;      // at least those of the light at hand, chart after chart
    std::vector<std::uint32_t> leaf_nodes_;  // beside them
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

/// `weight`: the cell's share of all weight emitted, per photon.
PublishedLeaf Publisher::fit_leaf(std::uint32_t node, const glm::dvec3& weight) const {
    const Cell<2>& cell = tree_.cell(node);
    const FieldSums<2>& sums = sums_[node];
    const LinearFit<2> fit(cell);
    const double ratio = pruning_.variance_ratio(node);
    PublishedLeaf leaf;
    leaf.box = cell.box;
    leaf.geometry = &cell.geometry;
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        leaf.density[band] = flux_per_weight_[band] * weight[band] / cell.geometry.area;
        auto slope = fit.weighted_slope(sums.weight[b], sums.moments[b]);
        for (double& s : slope) s = sums.weight[b] > 0 ? s / sums.weight[b] : 0;
        // On a full cell the fit must not fall below zero in a corner.
        const double steepest = std::abs(slope[0]) + std::abs(slope[1]);
        double limit = cell.geometry.full && steepest > 1 ? 1 / steepest : 1;
        if (settings_.constant_cells) limit = 0;
        for (std::size_t a = 0; a < 2; ++a) leaf.slopes[a][band] = leaf.density[band] * slope[a] * limit;
        if (sums.weight[b] > 0) {
            leaf.standard_error[band] = leaf.density[band] * std::sqrt(ratio * sums.squares[b]) / sums.weight[b];
        } else {
            // Nothing landed here: not known better than one photon of the chart's mean weight.
            const FieldSums<2>& chart = sums_[cell.chart];
            const double one = chart.weight[b] > 0 ? chart.squares[b] / chart.weight[b] : 0;
            leaf.standard_error[band] =
                pruning_.age(node) > 0 ? flux_per_weight_[band] * one / (pruning_.age(node) * cell.geometry.area) : 0;
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
    if (pruning_.is_published_leaf(node)) {
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
    leaves_.resize(leaf_nodes_.size());
    over_ranges(tree_.chart_count(), 1, threads_, [&](std::size_t chart, std::size_t) {
        const auto& total = sums_[chart].weight;
        const std::size_t begin = chart_begin_[chart];
        const auto node = static_cast<std::uint32_t>(chart);
        std::size_t next = begin;
        fit_below(node, glm::dvec3(total[0], total[1], total[2]) / pruning_.age(node), next);
        const std::span<PublishedLeaf> own(&leaves_[begin], next - begin);
        if (settings_.join_corners) {
            join_corners(own, [&](std::uint32_t u, std::uint32_t v) {
                return locate(roots_[chart], u, v) - static_cast<std::uint32_t>(begin);
            });
        } else {
            keep_own_corners(own);
        }
    });
}

// Into leaves_, from the next on.
void Publisher::fit_below(std::uint32_t node, const glm::dvec3& weight, std::size_t& next) {
    const TreeNode& tree_node = tree_.node(node);
    if (pruning_.is_published_leaf(node)) {
        leaves_[next++] = fit_leaf(node, weight);
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
    for (const std::uint32_t side : {0u, 1u}) fit_below(low + side, weight * shares[side], next);
}

std::uint32_t Publisher::locate(std::uint32_t root, std::uint32_t u, std::uint32_t v) const {
    glm::uvec2 node = snapshot_.nodes[root];
    while ((node.y & BREWSTER_NODE_LEAF) == 0) {
        const std::uint32_t x = (node.y >> BREWSTER_NODE_AXIS_SHIFT) == 0 ? u : v;
        node = snapshot_.nodes[(node.y & BREWSTER_NODE_INDEX) + (x < node.x ? 0u : 1u)];
    }
    return ((node.y & ~BREWSTER_NODE_LEAF) - first_leaf_) / static_cast<std::uint32_t>(worlds_);
}

void Publisher::write_leaves(int light, int world) {
    const std::size_t count = leaf_nodes_.size();
    std::vector<LeafExcess> excess(count);
    over_ranges(count, leaves_at_a_time, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            excess[i] = pruning_.excess(leaf_nodes_[i], sums_[leaf_nodes_[i]], leaves_[i].freedom);
    });
    const std::vector<double> hidden = hidden_structure(excess, chart_begin_);
    if (light == 1 && world == 0) places_.resize(count);
    over_ranges(count, leaves_at_a_time, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PublishedLeaf& leaf = leaves_[i];
            // The standard error holds the ratio already; hidden structure is told in units of the noise without it.
            const glm::dvec3 error = error_of(leaf, hidden[i] / pruning_.variance_ratio(leaf_nodes_[i]));
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
            places_[i] = {tree_.cell(leaf_nodes_[i]).chart, middle(0), middle(1), leaf.geometry->area};
        }
    });
}

/// A quarter of the median over the area, `area` in all: what boxes stand on and what lamps cover is darker, and cells
/// there that the border runs through know nothing of the side that is seen.
double Publisher::darkest_lit(const std::vector<glm::dvec2>& values, double area) const {
    std::vector<std::pair<double, double>> sorted(values.size());  // value, area
    for (std::size_t i = 0; i < values.size(); ++i) sorted[i] = {values[i].x, places_[i].area};
    std::sort(sorted.begin(), sorted.end());
    double below = 0;
    for (const auto& [value, own] : sorted) {
        below += own;
        if (2 * below >= area) return value / 4;
    }
    return 0;
}

/// Area-weighted rms of standard error over value where there is light, of the band mean of direct and indirect light
/// together; values below 1 % of the scene's mean count as that, so that black corners do not rule where half is black.
double Publisher::relative_error() const {
    std::vector<glm::dvec2> values(places_.size());  // value, squared standard error
    over_ranges(places_.size(), leaves_at_a_time, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Place& place = places_[i];
            const ChartBins& bins = snapshot_.charts[place.chart];
            for (const std::uint32_t root : {bins.direct_root, bins.indirect_root}) {
                const lookup::BinValue found = lookup::look_up(snapshot_, root, 0u, place.u, place.v);
                const double error = (found.standard_error.x + found.standard_error.y + found.standard_error.z) / 3.0;
                values[i].x += (found.value.x + found.value.y + found.value.z) / 3.0;
                values[i].y += error * error;
            }
        }
    });
    double mean = 0, area = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        mean += places_[i].area * values[i].x;
        area += places_[i].area;
    }
    const double least = 0.01 * mean / area, dark = darkest_lit(values, area);
    double squares = 0, lit_area = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i].x < dark) continue;
        lit_area += places_[i].area;
        const double value = std::max(values[i].x, least);
        if (value > 0) squares += places_[i].area * values[i].y / (value * value);
    }
    return std::sqrt(squares / lit_area);
}

}  // namespace

Snapshot publish(const BinTree<2>& tree, const EntryFields& fields, const Tally<2>* pending, std::uint64_t photons,
                 glm::dvec3 flux_per_weight, const BinSettings& settings, unsigned threads) {
    BREWSTER_CHECK(photons > 0, "nothing to publish before the first photon");
    BREWSTER_CHECK(tree.layout() == fields.layout(), "the tree keeps other fields");
    return Publisher(tree, fields, pending, photons, flux_per_weight, settings, threads).run();
}

}  // namespace brewster
