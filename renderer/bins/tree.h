#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/units.h"
#include "base/word_lanes.h"
#include "base/zeroed_array.h"
#include "bins/bin_settings.h"
#include "bins/outline.h"
#include "bins/record.h"
#include "bins/tally.h"
#include "shared/bin_layout.h"

namespace brewster {

/// A node of a tally tree, in the words of bin_layout.h; a leaf's index is its row in the tallies.
struct TreeNode {
    std::uint32_t split = 0;
    std::uint32_t word = BREWSTER_NODE_LEAF;

    bool is_leaf() const { return (word & BREWSTER_NODE_LEAF) != 0; }
    std::uint32_t leaf() const { return word & ~BREWSTER_NODE_LEAF; }
    std::uint32_t axis() const { return word >> BREWSTER_NODE_AXIS_SHIFT; }
    std::uint32_t low_child() const { return word & BREWSTER_NODE_INDEX; }
};

/// How a leaf turns fixed-point coordinates into its own of [-1, 1].
template <int D>
struct alignas(32) LeafFrame {
    std::array<std::uint32_t, D> low{};
    std::array<float, D> half{}, inverse_half{};
    std::array<float, D> padding{};  // whole rows (base/rows.h)

    float coordinate(std::uint32_t x, std::size_t axis) const {
        return (static_cast<float>(x - low[axis]) - half[axis]) * inverse_half[axis];
    }
};

/// A cell of any age: a split keeps the sums of its own time, its children hold what came later.
template <int D>
struct Cell {
    std::uint32_t chart = 0;
    Box<D> box;
    CellGeometry geometry;                 ///< of its position; directions fill their box evenly
    std::uint64_t birth = 0;               ///< photons emitted when it came to be
    std::vector<std::uint32_t> triangles;  ///< of the outline, inside the box; empty where the cell is full
};

/// What a density is per: m2 of surface, times projected solid angle where there are directions (the whole square of
/// directions is pi).
template <int D>
double cell_measure(const Cell<D>& cell) {
    double measure = cell.geometry.area;
    if constexpr (D == 4) {
        measure *= pi;
        for (std::size_t a = 2; a < D; ++a)
            measure *= static_cast<double>(cell.box.high[a] - cell.box.low[a]) / BREWSTER_UV_ONE;
    }
    return measure;
}

/// The trees of all charts, over position (D = 2) or position and direction (D = 4): descent for photons, sums and
/// splits at batch ends. Topology changes only in `split_leaves`, so photons of a batch may descend from any thread.
template <int D>
class BinTree {
  public:
    using Point = std::array<std::uint32_t, D>;
    using LanesPoint = std::array<WordLanes, D>;

    BinTree(std::vector<Outline> outlines, const RecordLayout<D>& layout, const BinSettings& settings);

    const RecordLayout<D>& layout() const { return layout_; }

    /// The leaf of a chart under fixed-point coordinates.
    std::uint32_t locate(std::uint32_t chart, const Point& point) const {
        TreeNode node = nodes_[chart];
        while (!node.is_leaf()) node = nodes_[node.low_child() + (point[node.axis()] < node.split ? 0u : 1u)];
        return node.leaf();
    }
    /// The same in lanes, in two steps, so that several directions of one place share the first. `enter`: the node
    /// that is reached by position alone; charts must be valid in all lanes. `descend`: from there to the leaf.
    WordLanes enter(WordLanes chart, WordLanes u, WordLanes v) const {
        if (directory_.empty()) return chart;
        constexpr int shift = BREWSTER_UV_BITS - directory_bits;
        const WordLanes column = u >> shift, row = v >> shift;
        const WordLanes start =
            gather<1>(directory_.data(), (chart << 2 * directory_bits) | (row << directory_bits) | column);
        if constexpr (D == 2) return start;
        return descent<true, 1>(start, {{{u, v}}})[0];
    }
    WordLanes descend(WordLanes node, const LanesPoint& point) const { return descent<false, 1>(node, {point})[0]; }
    /// Of several points at a time, so that their steps wait for memory together.
    template <std::size_t count>
    std::array<WordLanes, count> descend(WordLanes node, const std::array<LanesPoint, count>& points) const {
        return descent<false>(node, points);
    }
    const LeafFrame<D>& frame(std::uint32_t leaf) const { return frames_[leaf]; }

    std::size_t leaf_count() const { return frames_.size(); }
    std::size_t node_count() const { return nodes_.size(); }
    std::uint32_t chart_count() const { return static_cast<std::uint32_t>(outlines_.size()); }
    const TreeNode& node(std::uint32_t index) const { return nodes_[index]; }
    const Cell<D>& cell(std::uint32_t index) const { return cells_[index]; }
    CellSums sums(std::uint32_t index) const {
        const auto estimate = static_cast<std::size_t>(layout_.estimate_size());
        const auto test = static_cast<std::size_t>(layout_.test_size());
        return {{&estimate_sums_[index * estimate], estimate}, {&test_sums_[index * test], test}};
    }
    const Outline& outline(std::uint32_t chart) const { return outlines_[chart]; }

    void write(ByteWriter& file) const;
    /// The tree that was written, of the same outlines and layout; anything else is refused.
    static BinTree read(ByteReader& file, std::vector<Outline> outlines, const RecordLayout<D>& layout);

    /// Adds tallies to the sums of the leaves and leaves them at zero, on so many threads.
    void absorb(std::span<Tally<D>* const> tallies, unsigned threads = 1);
    void absorb(Tally<D>& tally) {
        Tally<D>* const one = &tally;
        absorb({&one, 1});
    }

    /// Tests every leaf that something was filed in since it was last tested and splits those that pass, the most valuable
    /// first, while the memory budget lasts. The others would give the same answer again, and a budget that is spent stays
    /// so. `photons`: emitted so far, in all. `bytes_elsewhere`: of the budget, what others hold.
    void split_leaves(std::uint64_t photons, const BinSettings& settings, std::size_t bytes_elsewhere = 0,
                      unsigned threads = 1);

    /// Records and two snapshots, by formula, so that the budget means the same on every machine.
    std::size_t bytes() const;

  private:
    static constexpr int directory_bits = 4;
    static constexpr std::uint32_t most_directories = 4096;

    // To the leaves' indices, or, by position alone, to the node where another axis or the leaf comes.
    template <bool by_position, std::size_t count>
    std::array<WordLanes, count> descent(WordLanes start, const std::array<LanesPoint, count>& points) const {
        constexpr std::uint32_t axes = by_position ? 2 : D;
        std::array<WordLanes, count> nodes, leaves;
        nodes.fill(start);
        for (;;) {
            LaneMask all_end = first_lanes(lane_count);
            for (std::size_t i = 0; i < count; ++i) {
                const auto words = gather_pair(&nodes_[0].split, nodes[i]);
                const WordLanes split = words.first, word = words.second;
                LaneMask ends = has_top_bit(word);
                if constexpr (by_position) ends = ends || has_top_bit(word << 1);  // an axis of directions
                all_end = all_end && ends;
                leaves[i] = by_position ? nodes[i] : word & WordLanes(~BREWSTER_NODE_LEAF);
                const WordLanes axis = word >> BREWSTER_NODE_AXIS_SHIFT;
                WordLanes coordinate = points[i][0];
                for (std::uint32_t a = 1; a < axes; ++a)
                    coordinate = select(equal(axis, WordLanes(a)), points[i][a], coordinate);
                const LaneMask low = below(coordinate, split);
                const WordLanes child =
                    (word & WordLanes(BREWSTER_NODE_INDEX)) + select(low, WordLanes(0u), WordLanes(1u));
                nodes[i] = select(ends, nodes[i], child);
            }
            if (!any_of(!all_end)) return leaves;
        }
    }
    void fill_directory(unsigned threads = 1);
    bool split_position(std::uint32_t index, int axis, std::uint32_t& position) const;
    std::array<Cell<D>, 2> halves(std::uint32_t index, int axis, std::uint32_t position, std::uint64_t photons) const;
    void split(std::uint32_t index, int axis, std::uint32_t position, std::array<Cell<D>, 2> children);
    void split(std::uint32_t index, int axis, std::uint32_t position, std::uint64_t photons) {
        split(index, axis, position, halves(index, axis, position, photons));
    }
    void split_along_contacts(std::uint32_t chart);
    void cut(std::uint32_t index, int axis, std::uint32_t position, std::uint32_t begin, std::uint32_t end);
    void split_evenly(std::uint32_t index, int levels, const glm::dvec2& size);

    void add_node(const TreeNode& node, Cell<D>&& cell);
    std::size_t bytes_per_node() const;

    std::vector<Outline> outlines_;
    RecordLayout<D> layout_;
    std::vector<TreeNode> nodes_;                  // the roots first, one a chart
    std::vector<Cell<D>> cells_;                   // beside nodes_
    ZeroedArray<Wide> estimate_sums_, test_sums_;  // beside nodes_, a record each
    std::vector<LeafFrame<D>> frames_;
    std::vector<std::uint32_t> node_of_leaf_;
    std::vector<std::uint8_t> untested_;    // per leaf: whether something was filed since it was last tested
    std::vector<std::uint32_t> directory_;  // 16 x 16 cells a chart: the node that all of a cell's light comes by
};

extern template class BinTree<2>;
extern template class BinTree<4>;

}  // namespace brewster
