#pragma once
#include <cstdint>
#include <vector>

#include "base/rows.h"

namespace brewster {

/// What photons of one thread found out about where they start, per cell of the guide.
struct GuideTally {
    std::vector<std::uint64_t> traced, useful;

    void resize(std::size_t cells) {
        traced.resize(cells);
        useful.resize(cells);
    }
    /// Moves the other's counts into this one and leaves it at zero.
    void take(GuideTally& other);
};

/// Learns where the photons start that meet something useful, and starts more of them there: the sun through a window.
///
/// Every lamp has a tree over two of the numbers that its photons start from, evenly divided at first. A leaf that
/// wastes many photons and does not waste many others is halved; a leaf of area a whose share f of photons was useful is
/// drawn with a probability in proportion to a sqrt(f) (the least variance for photons that are worth nothing or all),
/// blended with a tenth of plain emission, so that no weight 1/p grows beyond 10. While a leaf has few photons, f leans
/// on what is known around it. A lamp that wastes less than a tenth stays as it is, to the bit. Trees change in `learn`
/// only, at the ends of batches, from integer counts: the same for any number of threads.
class EmissionGuide {
  public:
    /// Per lamp, whether it can be guided: two of its numbers alone must say where a photon flies. Others stay as they are.
    explicit EmissionGuide(std::vector<bool> guided);

    template <class Real>
    struct Start {
        Real x, y;          ///< in [0, 1)
        Real weight;        ///< area of the cell over its probability, at most 10 and what rounding adds
        Word<Real> cell{};  ///< where it is counted
    };

    /// Moves a point, evenly distributed over all pairs of words, to where the guide wants it; order is kept, so that
    /// stratified points stay stratified. Of one photon, or of a batch of lanes.
    template <class Real>
    Start<Real> warp(const Word<Real>& lamp, const Word<Real>& x, const Word<Real>& y) const;

    std::size_t cell_count() const { return nodes_.size(); }

    /// Takes in what a batch counted, leaves the tally at zero, splits and weighs anew.
    void learn(GuideTally& tally);

    /// A cell: a leaf while it has no children, which stand together.
    struct Node {
        std::uint32_t low_child = 0;  ///< 0: none
        std::uint32_t axis = 0;
        std::uint64_t traced = 0, useful = 0;  ///< photons that started here while it was a leaf
        double low[2] = {0, 0}, size[2] = {1, 1};
        double low_share = 0.5;  ///< of its probability, the low child's
        // What is drawn: the pairs of words, halved, that lead here, a box; a leaf's share is the area of its box.
        std::uint32_t drawn_low[2] = {0, 0}, drawn_high[2] = {1u << 31, 1u << 31};
        float weight = 1;  ///< of a leaf: area over share
    };
    const std::vector<Node>& nodes() const { return nodes_; }
    /// Takes up nodes that were written down; what depends on them is worked out anew. False: they are no guide's.
    bool restore(std::vector<Node> nodes);

  private:
    std::vector<std::uint32_t> nodes_of(std::uint32_t lamp) const;
    void learn(std::uint32_t lamp);
    void split(std::uint32_t index);
    void weigh(const std::vector<std::uint32_t>& order);
    void share_out(const std::vector<std::uint32_t>& order);

    // A node as a descent reads it: where its words are split, and its low child with the axis on top; a leaf is its own
    // child and has the top bit.
    struct Step {
        std::uint32_t split = 0, word = leaf_bit;
    };
    static constexpr std::uint32_t leaf_bit = 1u << 31, axis_bit = 1u << 30;

    std::vector<bool> guided_;  // per lamp
    std::uint32_t lamps_;
    std::vector<Node> nodes_;  // the roots first, one a lamp
    std::vector<Step> steps_;  // beside nodes_
    std::vector<Row> moves_;   // beside nodes_: of a leaf, its box and where its points go
};

}  // namespace brewster
