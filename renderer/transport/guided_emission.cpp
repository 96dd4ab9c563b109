#include "transport/guided_emission.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.h"

namespace brewster {
namespace {

constexpr double plain_share = 0.1;        // of photons that start as if nothing had been learned
constexpr double useful_enough = 0.9;      // a lamp or cell that wastes less is left as it is
constexpr std::uint64_t telling = 64;      // wasted and useful photons each, before a cell is halved
constexpr double smallest_area = 0x1p-24;  // of a cell: even a tenth of it is drawn by several words of 31 bits
constexpr std::size_t first_cells = 1024, most_first_cells = 1 << 15;  // of one lamp, of all
constexpr std::size_t most_cells = 8192;                               // of one lamp, inner ones too
constexpr double surroundings = 2;  // how many photons what is known around a cell counts for

double area(const EmissionGuide::Node& node) {
    return node.size[0] * node.size[1];
}

}  // namespace

void GuideTally::take(GuideTally& other) {
    for (std::size_t cell = 0; cell < other.traced.size(); ++cell) {
        traced[cell] += other.traced[cell];
        useful[cell] += other.useful[cell];
        other.traced[cell] = other.useful[cell] = 0;
    }
}

EmissionGuide::EmissionGuide(std::vector<bool> guided)
    : guided_(std::move(guided)), lamps_(static_cast<std::uint32_t>(guided_.size())), nodes_(lamps_) {
    const std::size_t cells = std::min(first_cells, most_first_cells / std::max<std::size_t>(lamps_, 1));
    for (std::uint32_t lamp = 0; lamp < lamps_; ++lamp)
        for (std::size_t known = 1; guided_[lamp] && 2 * known <= cells; known *= 2)
            for (const std::uint32_t index : nodes_of(lamp))
                if (nodes_[index].low_child == 0) split(index);
    for (std::uint32_t lamp = 0; lamp < lamps_; ++lamp) share_out(nodes_of(lamp));
}

// A lamp's nodes, level by level.
std::vector<std::uint32_t> EmissionGuide::nodes_of(std::uint32_t lamp) const {
    std::vector<std::uint32_t> order = {lamp};
    for (std::size_t i = 0; i < order.size(); ++i)
        if (const std::uint32_t child = nodes_[order[i]].low_child) order.insert(order.end(), {child, child + 1});
    return order;
}

namespace {

enum : std::size_t { from_x, from_y, scale_x, scale_y, to_x, to_y, move_weight };

}  // namespace

template <class Real>
EmissionGuide::Start<Real> EmissionGuide::warp(const Word<Real>& lamp, const Word<Real>& x, const Word<Real>& y) const {
    const Word<Real> half_x = x >> 1, half_y = y >> 1, none(0u), one(1u);
    Word<Real> cell = lamp;
    for (;;) {
        const auto step = gather_pair(&steps_[0].split, cell);
        const auto ends = has_top_bit(step.second);
        if (!any_of(!ends)) break;
        const auto along_x = equal(step.second & Word<Real>(axis_bit), none);
        const auto low = below(select(along_x, half_x, half_y), step.first);
        const Word<Real> child = (step.second & Word<Real>(axis_bit - 1)) + select(low, none, one);
        cell = select(ends, cell, child);
    }
    const auto move = row_at(moves_, cell);
    const auto moved = [&](const Word<Real>& word, std::size_t axis) {
        const Real beyond = number_of(word - words_of(move[from_x + axis]));
        return min(fma(beyond, move[scale_x + axis], move[to_x + axis]), constant<Real>(0x1.fffffep-1));
    };
    return {moved(half_x, 0), moved(half_y, 1), move[move_weight], cell};
}

template EmissionGuide::Start<float> EmissionGuide::warp(const std::uint32_t&, const std::uint32_t&,
                                                         const std::uint32_t&) const;
template EmissionGuide::Start<FloatLanes> EmissionGuide::warp(const WordLanes&, const WordLanes&,
                                                              const WordLanes&) const;

void EmissionGuide::learn(GuideTally& tally) {
    BREWSTER_CHECK(tally.traced.size() == nodes_.size(), std::to_string(tally.traced.size()));
    for (std::size_t cell = 0; cell < nodes_.size(); ++cell) {
        nodes_[cell].traced += tally.traced[cell];
        nodes_[cell].useful += tally.useful[cell];
    }
    for (std::uint32_t lamp = 0; lamp < lamps_; ++lamp)
        if (guided_[lamp]) learn(lamp);
    tally.traced.assign(nodes_.size(), 0);
    tally.useful.assign(nodes_.size(), 0);
}

void EmissionGuide::learn(std::uint32_t lamp) {
    std::vector<std::uint32_t> order = nodes_of(lamp);
    std::size_t cells = order.size();
    for (const std::uint32_t index : order) {
        const Node& node = nodes_[index];
        if (node.low_child != 0 || node.useful < telling || node.traced < node.useful + telling) continue;
        if (static_cast<double>(node.useful) > useful_enough * static_cast<double>(node.traced)) continue;
        if (area(node) < smallest_area || cells + 2 > most_cells) continue;
        cells += 2;
        split(index);
    }
    weigh(nodes_of(lamp));
}

void EmissionGuide::split(std::uint32_t index) {
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index].low_child = child;
    nodes_[index].axis = nodes_[index].size[1] > nodes_[index].size[0] ? 1 : 0;
    const Node parent = nodes_[index];
    for (const int side : {0, 1}) {
        Node node;
        for (int a = 0; a < 2; ++a) {
            node.low[a] = parent.low[a];
            node.size[a] = parent.size[a];
        }
        node.size[parent.axis] *= 0.5;
        if (side == 1) node.low[parent.axis] += node.size[parent.axis];
        nodes_.push_back(node);
    }
}

// Pairs of children stand in the order of their parents, so a pass from the end sums up over whole branches and one
// from the front hands down.
void EmissionGuide::weigh(const std::vector<std::uint32_t>& order) {
    const std::size_t count = order.size();
    std::vector<double> traced(count), useful(count), share(count), probability(count);
    for (std::size_t i = count, pair = count; i-- > 0;) {
        const Node& node = nodes_[order[i]];
        traced[i] = static_cast<double>(node.traced);
        useful[i] = static_cast<double>(node.useful);
        if (node.low_child == 0) continue;
        pair -= 2;
        traced[i] += traced[pair] + traced[pair + 1];
        useful[i] += useful[pair] + useful[pair + 1];
    }
    const bool wastes = useful[0] < useful_enough * traced[0];
    share[0] = (useful[0] + surroundings) / (traced[0] + surroundings);
    double total = 0;
    for (std::size_t i = 0, pair = 1; i < count; ++i) {
        const Node& node = nodes_[order[i]];
        if (node.low_child == 0) {
            total += area(node) * std::sqrt(share[i]);
            continue;
        }
        for (const std::size_t child : {pair, pair + 1})
            share[child] = (useful[child] + surroundings * share[i]) / (traced[child] + surroundings);
        pair += 2;
    }
    for (std::size_t i = count, pair = count; i-- > 0;) {
        Node& node = nodes_[order[i]];
        if (node.low_child != 0) {
            pair -= 2;
            probability[i] = probability[pair] + probability[pair + 1];
            node.low_share = wastes ? probability[pair] / probability[i] : 0.5;
            continue;
        }
        probability[i] = plain_share * area(node) + (1 - plain_share) * area(node) * std::sqrt(share[i]) / total;
    }
    share_out(order);
}

// Words from the root's box downwards. No cell goes without, and what each gets by rounding is what its weight says.
void EmissionGuide::share_out(const std::vector<std::uint32_t>& order) {
    steps_.resize(nodes_.size());
    moves_.resize(nodes_.size());
    for (const std::uint32_t index : order) {
        Node& node = nodes_[index];
        const std::uint32_t* const low = node.drawn_low;
        const std::uint32_t* const high = node.drawn_high;
        if (node.low_child != 0) {
            const std::uint32_t a = node.axis, width = high[a] - low[a];
            BREWSTER_CHECK(width >= 2, std::to_string(index));
            const auto share = static_cast<std::uint32_t>(std::llround(node.low_share * width));
            const std::uint32_t split = low[a] + std::clamp(share, 1u, width - 1);
            for (const std::uint32_t side : {0u, 1u}) {
                Node& child = nodes_[node.low_child + side];
                std::copy_n(low, 2, child.drawn_low);
                std::copy_n(high, 2, child.drawn_high);
                (side == 0 ? child.drawn_high : child.drawn_low)[a] = split;
            }
            steps_[index] = {split, node.low_child | (a != 0 ? axis_bit : 0u)};
            continue;
        }
        double drawn = 1;
        Row& move = moves_[index];
        for (std::size_t a = 0; a < 2; ++a) {
            const double width = high[a] - low[a];
            drawn *= 0x1p-31 * width;
            move.x[from_x + a] = floats_of(low[a]);
            move.x[scale_x + a] = static_cast<float>(node.size[a] / width);
            move.x[to_x + a] = static_cast<float>(node.low[a]);
        }
        node.weight = static_cast<float>(area(node) / drawn);
        move.x[move_weight] = node.weight;
        steps_[index] = {};
    }
}

bool EmissionGuide::restore(std::vector<Node> nodes) {
    if (nodes.size() < lamps_) return false;
    std::vector<Node> before(lamps_);
    nodes_.swap(before);
    // Splits happened in the order of their children.
    std::vector<std::uint32_t> parents;
    for (std::uint32_t index = 0; index < nodes.size(); ++index)
        if (nodes[index].low_child != 0) parents.push_back(index);
    std::sort(parents.begin(), parents.end(),
              [&](std::uint32_t a, std::uint32_t b) { return nodes[a].low_child < nodes[b].low_child; });
    bool possible = true;
    for (const std::uint32_t parent : parents) {
        possible = possible && parent < nodes_.size() && nodes[parent].low_child == nodes_.size() &&
                   nodes_.size() < nodes.size() && nodes_[parent].low_child == 0;
        if (possible) split(parent);
    }
    possible = possible && nodes_.size() == nodes.size();
    for (std::size_t i = 0; possible && i < nodes.size(); ++i) {
        possible = nodes[i].useful <= nodes[i].traced;
        nodes_[i].traced = nodes[i].traced;
        nodes_[i].useful = nodes[i].useful;
    }
    if (!possible) nodes_.swap(before);
    for (std::uint32_t lamp = 0; lamp < lamps_; ++lamp) {
        if (guided_[lamp])
            weigh(nodes_of(lamp));
        else
            share_out(nodes_of(lamp));
    }
    return possible;
}

}  // namespace brewster
