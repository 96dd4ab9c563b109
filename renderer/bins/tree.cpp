#include "bins/tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/check.h"
#include "base/threads.h"
#include "bins/half_difference.h"
#include "bins/split_test.h"

namespace brewster {
namespace {

constexpr std::uint32_t smallest_size = BREWSTER_UV_ONE >> 12;  // a cell's least extent: 1/4096 of its chart
constexpr std::size_t leaves_at_a_time = 512, splits_at_a_time = 64, charts_at_a_time = 64;

template <int D>
Box<2> position_box(const Box<D>& box) {
    return {{box.low[0], box.low[1]}, {box.high[0], box.high[1]}};
}

template <int D>
LeafFrame<D> frame_of(const Box<D>& box) {
    LeafFrame<D> frame;
    for (std::size_t a = 0; a < D; ++a) {
        frame.low[a] = box.low[a];
        frame.half[a] = 0.5f * static_cast<float>(box.high[a] - box.low[a]);
        frame.inverse_half[a] = 1.0f / frame.half[a];
    }
    return frame;
}

std::uint32_t fixed(double unit) {
    return static_cast<std::uint32_t>(std::clamp(std::lround(unit * BREWSTER_UV_ONE), 0L, long{BREWSTER_UV_ONE}));
}

}  // namespace

template <int D>
BinTree<D>::BinTree(std::vector<Outline> outlines, const RecordLayout<D>& layout, const BinSettings& settings)
    : outlines_(std::move(outlines)), layout_(layout) {
    const std::uint32_t charts = chart_count();
    double total_area = 0;
    for (std::uint32_t chart = 0; chart < charts; ++chart) {
        Cell<D> cell;
        cell.chart = chart;
        for (std::size_t a = 0; a < D; ++a) cell.box.high[a] = BREWSTER_UV_ONE;
        cell.triangles.resize(outlines_[chart].triangles.size());
        std::iota(cell.triangles.begin(), cell.triangles.end(), 0u);
        cell.geometry = cell_geometry(outlines_[chart], position_box(cell.box), cell.triangles);
        BREWSTER_CHECK(cell.geometry.area > 0, "chart " + std::to_string(chart) + " has no area");
        if (cell.geometry.full) cell.triangles.clear();
        total_area += cell.geometry.area;
        TreeNode node;
        node.word = BREWSTER_NODE_LEAF | chart;
        frames_.push_back(frame_of(cell.box));
        node_of_leaf_.push_back(chart);
        add_node(node, std::move(cell));
    }
    if (settings.fixed_grid_log2 >= 0) {
        for (std::uint32_t chart = 0; chart < charts; ++chart) {
            split_evenly(chart, 2 * settings.fixed_grid_log2, glm::dvec2(1));
        }
        fill_directory();
        return;
    }
    if (settings.half_differences) {
        fill_directory();
        return;
    }
    for (std::uint32_t chart = 0; chart < charts; ++chart) split_along_contacts(chart);
    // A lobe has a shape in every place: cells of position alone would have to be kept for the sake of the directions
    // that are split below them. So photons decide what is split first.
    if (D == 4) return;
    // Splits made before the first photon lose no sums; a few thousand cells cost little and are pruned where they tell
    // nothing.
    const double first_cells =
        std::min(8192.0, 0.25 * static_cast<double>(settings.memory_bytes) / static_cast<double>(bytes_per_node()));
    const std::size_t contact_nodes = nodes_.size();
    for (std::uint32_t index = 0; index < contact_nodes; ++index) {
        if (!nodes_[index].is_leaf()) continue;
        const double share = first_cells * cells_[index].geometry.area / total_area;
        const int levels = static_cast<int>(std::floor(std::log2(std::max(share, 1.0))));
        split_evenly(index, std::min(levels, 12), outlines_[cells_[index].chart].size);
    }
    fill_directory();
}

// Of many charts, each has few leaves, and a directory would be longer than the way.
template <int D>
void BinTree<D>::fill_directory(unsigned threads) {
    if (chart_count() > most_directories) return;
    constexpr std::uint32_t cells = 1u << directory_bits, size = BREWSTER_UV_ONE >> directory_bits;
    directory_.resize(std::size_t{chart_count()} * cells * cells);
    over_ranges(chart_count(), charts_at_a_time, threads, [&](std::size_t begin, std::size_t end) {
        std::uint32_t* entry = &directory_[begin * cells * cells];
        for (auto chart = static_cast<std::uint32_t>(begin); chart < end; ++chart)
            for (std::uint32_t row = 0; row < cells; ++row)
                for (std::uint32_t column = 0; column < cells; ++column) {
                    const std::array<std::uint32_t, 2> low = {column * size, row * size};
                    std::uint32_t index = chart;
                    for (;;) {
                        const TreeNode& node = nodes_[index];
                        if (node.is_leaf() || node.axis() >= 2) break;
                        const bool below_split = low[node.axis()] + size <= node.split;
                        if (!below_split && low[node.axis()] < node.split) break;  // the border runs through the cell
                        index = node.low_child() + (below_split ? 0u : 1u);
                    }
                    *entry++ = index;
                }
    });
}

// The middle of what is occupied, so that no child is empty.
template <int D>
bool BinTree<D>::split_position(std::uint32_t index, int axis, std::uint32_t& position) const {
    const auto a = static_cast<std::size_t>(axis);
    const Cell<D>& cell = cells_[index];
    const std::uint32_t low = cell.box.low[a], high = cell.box.high[a];
    if (high - low < 2 * outlines_[cell.chart].least_cell) return false;
    const double middle = a < 2 ? cell.geometry.middle[a] : 0.0;
    position = low + static_cast<std::uint32_t>(std::lround((0.5 + 0.5 * middle) * (high - low)));
    return position > low && position < high;
}

template <int D>
std::array<Cell<D>, 2> BinTree<D>::halves(std::uint32_t index, int axis, std::uint32_t position,
                                          std::uint64_t photons) const {
    const auto a = static_cast<std::size_t>(axis);
    const Cell<D>& cell = cells_[index];
    std::array<Cell<D>, 2> children;
    for (const std::size_t side : {0u, 1u}) {
        Cell<D>& child = children[side];
        child.chart = cell.chart;
        child.box = cell.box;
        (side == 0 ? child.box.high : child.box.low)[a] = position;
        child.birth = photons;
        if (cell.geometry.full) {
            child.geometry = cell.geometry;
            if (a < 2) {
                child.geometry.area *= static_cast<double>(child.box.high[a] - child.box.low[a]) /
                                       static_cast<double>(cell.box.high[a] - cell.box.low[a]);
            }
        } else if (a >= 2) {  // the same place, half of the directions
            child.geometry = cell.geometry;
            child.triangles = cell.triangles;
        } else {
            const Outline& outline = outlines_[child.chart];
            child.triangles = triangles_in(outline, position_box(child.box), cell.triangles);
            child.geometry = cell_geometry(outline, position_box(child.box), child.triangles);
            if (child.geometry.full) child.triangles.clear();
        }
    }
    return children;
}

template <int D>
void BinTree<D>::split(std::uint32_t index, int axis, std::uint32_t position, std::array<Cell<D>, 2> children) {
    const auto low_child = static_cast<std::uint32_t>(nodes_.size());
    const std::uint32_t leaf = nodes_[index].leaf();
    BREWSTER_CHECK(low_child + 1 < BREWSTER_NODE_INDEX, "too many nodes for the layout");
    for (int side = 0; side < 2; ++side) {
        Cell<D>& child = children[static_cast<std::size_t>(side)];
        const std::uint32_t row = side == 0 ? leaf : static_cast<std::uint32_t>(frames_.size());
        if (side == 1) {
            frames_.emplace_back();
            node_of_leaf_.emplace_back();
        }
        frames_[row] = frame_of(child.box);
        node_of_leaf_[row] = low_child + static_cast<std::uint32_t>(side);
        TreeNode node;
        node.word = BREWSTER_NODE_LEAF | row;
        add_node(node, std::move(child));
    }
    nodes_[index].split = position;
    nodes_[index].word = static_cast<std::uint32_t>(axis) << BREWSTER_NODE_AXIS_SHIFT | low_child;
    cells_[index].triangles = {};
}

// Light jumps where surfaces meet, so the first borders lie there. Only lines along u or v can be borders.
template <int D>
void BinTree<D>::split_along_contacts(std::uint32_t chart) {
    constexpr double parallel = 1e-4, least = 1.0 / 256;  // of the chart's extent
    constexpr int most_lines = 16;
    int lines = 0;
    for (const auto& [from, to] : outlines_[chart].contacts) {
        for (int axis = 0; axis < 2 && lines < most_lines; ++axis) {
            const double at = 0.5 * (from[axis] + to[axis]);
            const int along = 1 - axis;
            if (std::abs(from[axis] - to[axis]) > parallel || std::abs(from[along] - to[along]) < least) continue;
            if (at < least || at > 1 - least) continue;
            ++lines;
            cut(chart, axis, fixed(at), fixed(std::min(from[along], to[along])),
                fixed(std::max(from[along], to[along])));
        }
    }
}

// Splits the leaves below a node that the line crosses, unless a side would be a sliver or hold no surface.
template <int D>
void BinTree<D>::cut(std::uint32_t index, int axis, std::uint32_t position, std::uint32_t begin, std::uint32_t end) {
    const auto a = static_cast<std::size_t>(axis), b = 1 - a;
    const Box<D>& box = cells_[index].box;
    constexpr std::uint32_t sliver = 4 * smallest_size;
    if (position < box.low[a] + sliver || position + sliver > box.high[a]) return;
    if (begin + sliver > box.high[b] || end < box.low[b] + sliver) return;
    if (!nodes_[index].is_leaf()) {
        const std::uint32_t child = nodes_[index].low_child();
        cut(child, axis, position, begin, end);
        cut(child + 1, axis, position, begin, end);
        return;
    }
    if (!cells_[index].geometry.full) {
        for (const bool low_side : {true, false}) {
            Box<2> side = position_box(box);
            (low_side ? side.high : side.low)[a] = position;
            if (cell_geometry(outlines_[cells_[index].chart], side, cells_[index].triangles).area <= 0) return;
        }
    }
    split(index, axis, position, 0);
}

// Halves the longer side, in metres.
template <int D>
void BinTree<D>::split_evenly(std::uint32_t index, int levels, const glm::dvec2& size) {
    if (levels <= 0) return;
    const Box<D>& box = cells_[index].box;
    const int axis = size.y * (box.high[1] - box.low[1]) > size.x * (box.high[0] - box.low[0]) ? 1 : 0;
    std::uint32_t position = 0;
    if (!split_position(index, axis, position)) return;
    split(index, axis, position, 0);
    const std::uint32_t child = nodes_[index].low_child();
    split_evenly(child, levels - 1, size);
    split_evenly(child + 1, levels - 1, size);
}

template <int D>
void BinTree<D>::add_node(const TreeNode& node, Cell<D>&& cell) {
    nodes_.push_back(node);
    cells_.push_back(std::move(cell));
    estimate_sums_.resize(estimate_sums_.size() + static_cast<std::size_t>(layout_.estimate_size()));
    test_sums_.resize(test_sums_.size() + static_cast<std::size_t>(layout_.test_size()));
}

// Half the nodes are leaves; a snapshot holds at most two nodes for each of them, and for each field and leaf the corner
// texels of D = 2, or as many as a value and its slopes fill.
template <int D>
std::size_t BinTree<D>::bytes_per_node() const {
    const std::size_t records = sizeof(Wide) * static_cast<std::size_t>(layout_.estimate_size() + layout_.test_size());
    const std::size_t published =
        2 * sizeof(TreeNode) + BREWSTER_LEAF_TEXELS * 4 * sizeof(float) * static_cast<std::size_t>(layout_.fields);
    return sizeof(TreeNode) + sizeof(Cell<D>) + records + sizeof(LeafFrame<D>) / 2 + 2 * published;
}

template <int D>
std::size_t BinTree<D>::bytes() const {
    return node_count() * bytes_per_node();
}

template <int D>
void BinTree<D>::absorb(std::span<Tally<D>* const> tallies, unsigned threads) {
    const auto estimate = static_cast<std::size_t>(layout_.estimate_size());
    const auto test = static_cast<std::size_t>(layout_.test_size());
    untested_.resize(leaf_count());
    over_ranges(leaf_count(), leaves_at_a_time, threads, [&](std::size_t begin, std::size_t end) {
        for (auto leaf = static_cast<std::uint32_t>(begin); leaf < end; ++leaf)
            for (Tally<D>* const tally : tallies) {
                if (!tally->touched(leaf)) continue;
                const std::size_t node = node_of_leaf_[leaf];
                tally->move(leaf, &estimate_sums_[node * estimate], &test_sums_[node * test]);
                untested_[leaf] = 1;
            }
    });
}

template <int D>
void BinTree<D>::split_leaves(std::uint64_t photons, const BinSettings& settings, std::size_t bytes_elsewhere,
                              unsigned threads) {
    if (settings.fixed_grid_log2 >= 0) return;
    struct Candidate {
        double value;
        std::uint32_t node;
        int axis;
        std::uint32_t position;
    };
    std::vector<std::vector<Candidate>> found((leaf_count() + leaves_at_a_time - 1) / leaves_at_a_time);
    untested_.resize(leaf_count());
    over_ranges(leaf_count(), leaves_at_a_time, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t leaf = begin; leaf < end; ++leaf) {
            if (untested_[leaf] == 0) continue;
            untested_[leaf] = 0;
            const std::uint32_t index = node_of_leaf_[leaf];
            const NullMoments<D> null = null_moments<D>(cells_[index].geometry);
            const auto choice = settings.half_differences ? choose_half<D>(sums(index), null)
                                                          : choose_split<D>(layout_, sums(index), null, settings);
            if (!choice) continue;
            Candidate candidate{choice->z_squared * choice->power, index, choice->axis, 0};
            if (split_position(index, candidate.axis, candidate.position))
                found[begin / leaves_at_a_time].push_back(candidate);
        }
    });
    std::vector<Candidate> candidates;
    for (const auto& some : found) candidates.insert(candidates.end(), some.begin(), some.end());
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.value != b.value ? a.value > b.value : a.node < b.node;
    });
    const std::size_t used = bytes() + bytes_elsewhere, split_bytes = 2 * bytes_per_node();
    const std::size_t affordable = used < settings.memory_bytes ? (settings.memory_bytes - used) / split_bytes : 0;
    if (candidates.size() > affordable) candidates.resize(affordable);
    std::vector<std::array<Cell<D>, 2>> children(candidates.size());
    over_ranges(candidates.size(), splits_at_a_time, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            children[i] = halves(candidates[i].node, candidates[i].axis, candidates[i].position, photons);
    });
    for (std::size_t i = 0; i < candidates.size(); ++i)
        split(candidates[i].node, candidates[i].axis, candidates[i].position, std::move(children[i]));
    fill_directory(threads);
}

template class BinTree<2>;
template class BinTree<4>;

}  // namespace brewster
