#pragma once
#include <array>
#include <vector>

#include "base/zeroed_array.h"
#include "bins/bin_settings.h"
#include "bins/bottom_up.h"
#include "bins/error_estimate.h"
#include "bins/hidden_structure.h"
#include "bins/light_sums.h"
#include "bins/linear_fit.h"
#include "bins/tree.h"

namespace brewster {

/// Sums of a field for every node, children's included.
template <int D>
using NodeSums = ZeroedArray<FieldSums<D>>;

/// What publishing a tree starts from: sums of whole subtrees, and which splits the photons so far justify.
template <int D>
class Pruning {
  public:
    using Fields = std::vector<const NodeSums<D>*>;

    static constexpr std::size_t looked_below =
        5;  ///< levels of the tally tree under a published leaf that its bar asks

    /// Keeps references. `pending`: tallies of the running batch, or null.
    Pruning(const BinTree<D>& tree, const Tally<D>* pending, std::uint64_t photons, const BinSettings& settings,
            unsigned threads);

    /// Fills an array that may have held another field's: clearing new pages would take as long.
    void sum_up(int field, NodeSums<D>& sums) const;

    /// Chooses the splits worth publishing for the fields whose sums are given; the first is the intensity against which
    /// errors count. Bottom-up: a split is kept if what it adds to the parent's linear fit, plus what its children gain,
    /// exceeds 2 lambda times its noise. On position, where light is known to bend, finer structure is likely: under a
    /// leaf that has a published split above it, two levels of splits are held against a smaller lambda. Even light stays
    /// in one cell.
    void choose(const Fields& fields);

    bool is_published_leaf(std::uint32_t node) const { return tree_.node(node).is_leaf() || keep_[node] == 0; }

    /// Photons emitted since the cell came to be.
    double age(std::uint32_t node) const { return static_cast<double>(photons_ - tree_.cell(node).birth); }

    /// By how much sum w^2 of the first field is off as a variance in this published leaf. Stratified emission makes it
    /// too large, paths that come back too small; the spread of the replicas says by how much. One leaf alone knows it
    /// with seven degrees of freedom, so it leans on its chart, and that on the scene.
    double variance_ratio(std::uint32_t node) const;

    /// What is known of unpublished structure under a leaf; `freedom`: numbers fitted from its photons alone.
    LeafExcess excess(std::uint32_t node, const FieldSums<D>& sums, double freedom) const;

  private:
    static constexpr bool asks_tests = D == 4;  // gloss: cells whose splits are young
    static constexpr bool refines = D == 2;     // of gloss one scene gains by it, another loses
    static constexpr double near_lambda = 0.7;
    static constexpr int near_levels = 2;

    // What a split adds to the parent's linear fit, and the noise of that; of all fields, and of the first alone.
    struct Evidence {
        bool any = false;  // light, since the split
        double detail = 0, noise = 0, first_detail = 0, first_noise = 0;
    };

    bool is_pending(std::uint32_t node) const;
    auto test_of(std::uint32_t node) const;
    void gather_spreads();
    void pool_tally_spreads();
    double misfit(std::uint32_t node, const FieldSums<D>& sums) const;
    Evidence evidence(std::uint32_t node, const Fields& fields) const;
    void refine(const Fields& fields);
    double gain_near(std::uint32_t node, int levels, const Fields& fields);
    void pool_spreads();

    const BinTree<D>& tree_;
    const Tally<D>* pending_;
    const std::uint64_t photons_;
    const BinSettings& settings_;
    const unsigned threads_;
    const BottomUp<D> nodes_;
    ZeroedArray<Spread> spreads_;     // per node
    ZeroedArray<std::uint8_t> keep_;  // per node: whether its split is published
    // Per node: what its split explains beyond noise of the first field, with those of one, two .. levels below; of gloss,
    // what its own test saw where no split has been known for half of all photons. Squared density x measure.
    ZeroedArray<std::array<double, looked_below>> unresolved_;
    ZeroedArray<double> gain_;         // per node: what publishing the splits from here on gains
    std::vector<double> tally_ratio_;  // per chart: spread over sum w^2 of the tally tree's leaves
    std::vector<std::array<double, band_count>> importance_;  // per chart
    std::vector<double> chart_ratio_;                         // per chart: pooled spread over sum w^2
};

extern template class Pruning<2>;
extern template class Pruning<4>;

}  // namespace brewster
