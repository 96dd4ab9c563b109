#include "bins/publish_gloss.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/threads.h"
#include "bins/lookup.h"
#include "bins/pruning.h"

namespace brewster {
namespace {

using Sums = NodeSums<4>;

constexpr std::size_t leaves_at_a_time = 256;

// A linear function of the cell coordinates, one band.
struct Linear {
    double mean = 0;
    std::array<double, 4> slopes{};

    double steepest() const {
        double sum = 0;
        for (const double s : slopes) sum += std::abs(s);
        return sum;
    }
};

class GlossPublisher {
  public:
    GlossPublisher(const BinTree<4>& tree, const GlossFields& fields, const Tally<4>* pending, std::uint64_t photons,
                   glm::dvec3 flux_per_weight, const BinSettings& settings, unsigned threads)
        : tree_(tree),
          fields_(fields),
          pruning_(tree, pending, photons, settings, threads),
          settings_(settings),
          flux_per_weight_(flux_per_weight),
          threads_(threads),
          field_count_(static_cast<std::size_t>(fields.layout().fields)) {
        for (std::size_t field = 0; field < field_count_; ++field)
            pruning_.sum_up(static_cast<int>(field), sums_.emplace_back());
        std::vector<const Sums*> all;
        for (const Sums& sums : sums_) all.push_back(&sums);
        pruning_.choose(all);
    }

    GlossBins run() {
        bins_.components = fields_.components;
        for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart) {
            const auto root = static_cast<std::uint32_t>(bins_.nodes.size());
            bins_.roots.push_back(root);
            bins_.nodes.emplace_back();
            chart_begin_.push_back(leaves_.size());
            lay_out_node(chart, root, total(sums_[0], chart), total(sums_[unpolarized()], chart));
        }
        chart_begin_.push_back(leaves_.size());
        bins_.leaves.resize(leaves_.size() * field_count_ * BREWSTER_GLOSS_FIELD_TEXELS);
        over_ranges(leaves_.size(), leaves_at_a_time, threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t leaf = begin; leaf < end; ++leaf) write_leaf(leaf);
        });
        add_hidden_structure();
        return std::move(bins_);
    }

  private:
    struct Leaf {
        std::uint32_t node;
        glm::dvec3 weight, unpolarized;  // per photon emitted
    };

    std::size_t unpolarized() const { return static_cast<std::size_t>(fields_.unpolarized_field()); }

    // Weight per photon emitted.
    glm::dvec3 total(const Sums& sums, std::uint32_t chart) const {
        const auto& weight = sums[chart].weight;
        return glm::dvec3(weight[0], weight[1], weight[2]) / pruning_.age(chart);
    }

    // What of the parent's goes to each child, by their shares since the split.
    std::array<glm::dvec3, 2> shared_out(const Sums& sums, std::uint32_t low, const glm::dvec3& weight) const {
        std::array<glm::dvec3, 2> parts;
        const double low_measure = cell_measure(tree_.cell(low)), high_measure = cell_measure(tree_.cell(low + 1));
        for (std::size_t b = 0; b < band_count; ++b) {
            const double together = sums[low].weight[b] + sums[low + 1].weight[b];
            const double share =
                together > 0 ? sums[low].weight[b] / together : low_measure / (low_measure + high_measure);
            const auto band = static_cast<int>(b);
            parts[0][band] = weight[band] * share;
            parts[1][band] = weight[band] * (1 - share);
        }
        return parts;
    }

    void lay_out_node(std::uint32_t node, std::uint32_t slot, const glm::dvec3& weight, const glm::dvec3& unpolarized) {
        if (pruning_.is_published_leaf(node)) {
            bins_.nodes[slot] = {0u, BREWSTER_NODE_LEAF | static_cast<std::uint32_t>(leaves_.size())};
            leaves_.push_back({node, weight, unpolarized});
            return;
        }
        const TreeNode& tree_node = tree_.node(node);
        const std::uint32_t low = tree_node.low_child();
        const auto child_slot = static_cast<std::uint32_t>(bins_.nodes.size());
        bins_.nodes.resize(child_slot + 2);
        bins_.nodes[slot] = {tree_node.split, tree_node.axis() << BREWSTER_NODE_AXIS_SHIFT | child_slot};
        const auto parts = shared_out(sums_[0], low, weight);
        const auto unpolarized_parts = shared_out(sums_[this->unpolarized()], low, unpolarized);
        for (const std::uint32_t side : {0u, 1u})
            lay_out_node(low + side, child_slot + side, parts[side], unpolarized_parts[side]);
    }

    void write_leaf(std::size_t index) {
        const auto& [node, weight, unpolarized] = leaves_[index];
        const LinearFit<4> fit(tree_.cell(node));
        const double ratio = pruning_.variance_ratio(node);
        std::array<Linear, band_count> found, intensity;  // of S0: before its limit, and after
        for (std::size_t field = 0; field < field_count_; ++field) {
            const bool is_intensity = field == 0 || field == this->unpolarized();
            const glm::dvec3& share = field == 0 || field != this->unpolarized() ? weight : unpolarized;
            glm::vec4* texels = &bins_.leaves[(index * field_count_ + field) * BREWSTER_GLOSS_FIELD_TEXELS];
            for (std::size_t b = 0; b < band_count; ++b) {
                const auto band = static_cast<int>(b);
                const double density = flux_per_weight_[band] * share[band] / fit.measure();
                // All of a polarized field is relative to the intensity's sum in the same leaf.
                const double denominator = sums_[is_intensity ? field : 0][node].weight[b];
                Linear linear = fitted(fit, sums_[field][node], b, denominator > 0 ? density / denominator : 0);
                if (field == 0) found[b] = linear;
                if (is_intensity)
                    limit(linear);
                else
                    limit_polarized(linear, found[b], intensity[b]);
                if (settings_.constant_cells) linear.slopes = {};
                if (field == 0) intensity[b] = linear;
                const double error = denominator > 0
                                         ? density * std::sqrt(ratio * sums_[field][node].squares[b]) / denominator
                                         : empty_error(field, node, b, fit.measure());
                write_band(texels, band, fit, linear, error);
            }
        }
    }

    // The look-up takes pruning to hide so many times the noise everywhere; here errors grow where more is seen.
    void add_hidden_structure() {
        std::vector<LeafExcess> excess;
        for (const Leaf& leaf : leaves_) excess.push_back(pruning_.excess(leaf.node, sums_[0][leaf.node], 5));
        const std::vector<double> hidden = hidden_structure(excess, chart_begin_);
        const std::size_t texels_per_leaf = BREWSTER_GLOSS_FIELD_TEXELS * field_count_;
        for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
            const double taken = static_cast<double>(BREWSTER_HIDDEN_STRUCTURE);
            const double more = std::max(taken, hidden[leaf] / pruning_.variance_ratio(leaves_[leaf].node));
            const auto factor = static_cast<float>(std::sqrt((1 + more) / (1 + taken)));
            for (std::size_t field = 0; field < field_count_; ++field)
                for (std::size_t band = 0; band < band_count; ++band)
                    bins_.leaves[leaf * texels_per_leaf + field * BREWSTER_GLOSS_FIELD_TEXELS + band].w *= factor;
        }
    }

    static Linear fitted(const LinearFit<4>& fit, const FieldSums<4>& sums, std::size_t b, double scale) {
        Linear linear;
        linear.mean = scale * sums.weight[b];
        linear.slopes = fit.weighted_slope(sums.weight[b], sums.moments[b]);
        for (double& s : linear.slopes) s *= scale;
        return linear;
    }

    // An intensity must not fall below zero in a corner.
    static void limit(Linear& linear) {
        const double steepest = linear.steepest();
        if (steepest <= linear.mean) return;
        for (double& s : linear.slopes) s *= steepest > 0 ? linear.mean / steepest : 0;
    }

    // A constant share of the intensity stays one. What the field does beyond that must not exceed what of the mean
    // intensity is not polarized this way.
    static void limit_polarized(Linear& linear, const Linear& found, const Linear& intensity) {
        const double share = intensity.mean > 0 ? std::clamp(linear.mean / intensity.mean, -1.0, 1.0) : 0;
        Linear rest = linear;
        for (std::size_t a = 0; a < 4; ++a) rest.slopes[a] -= share * found.slopes[a];
        const double room = std::max(0.0, intensity.mean - std::abs(linear.mean)), steepest = rest.steepest();
        const double kept = steepest > room ? room / steepest : 1;
        for (std::size_t a = 0; a < 4; ++a) linear.slopes[a] = share * intensity.slopes[a] + kept * rest.slopes[a];
    }

    // Nothing landed here: not known better than one photon of the chart's mean weight.
    double empty_error(std::size_t field, std::uint32_t node, std::size_t b, double measure) const {
        const FieldSums<4>& chart = sums_[field == this->unpolarized() ? field : 0][tree_.cell(node).chart];
        const double one = chart.weight[b] > 0 ? chart.squares[b] / chart.weight[b] : 0;
        const double age = pruning_.age(node);
        return age > 0 ? flux_per_weight_[static_cast<int>(b)] * one / (age * measure) : 0;
    }

    static void write_band(glm::vec4* texels, int band, const LinearFit<4>& fit, const Linear& linear, double error) {
        double constant = linear.mean;
        for (std::size_t a = 0; a < 4; ++a) constant -= linear.slopes[a] * fit.mean(a);
        texels[0][band] = static_cast<float>(constant);
        for (std::size_t a = 0; a < 4; ++a) texels[1 + a][band] = static_cast<float>(linear.slopes[a]);
        texels[band].w = static_cast<float>(error);
    }

    const BinTree<4>& tree_;
    const GlossFields fields_;
    Pruning<4> pruning_;
    const BinSettings& settings_;
    const glm::dvec3 flux_per_weight_;
    const unsigned threads_;
    const std::size_t field_count_;
    std::vector<Sums> sums_;    // per field
    std::vector<Leaf> leaves_;  // that are published
    GlossBins bins_;
    std::vector<std::size_t> chart_begin_;  // into leaves_, per chart and one more
};

}  // namespace

GlossBins publish_gloss(const BinTree<4>& tree, const GlossFields& fields, const Tally<4>* pending,
                        std::uint64_t photons, glm::dvec3 flux_per_weight, const BinSettings& settings,
                        unsigned threads) {
    BREWSTER_CHECK(photons > 0, "nothing to publish before the first photon");
    BREWSTER_CHECK(tree.layout() == fields.layout(), "the tree keeps other fields");
    return GlossPublisher(tree, fields, pending, photons, flux_per_weight, settings, threads).run();
}

}  // namespace brewster
