#include "scene/box_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>

namespace brewster {
namespace {

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Box bounds = boxes_[order_[first]];
    for (std::uint32_t i = first; i < first + count; ++i) {
        bounds.low = glm::min(bounds.low, boxes_[order_[i]].low);
        bounds.high = glm::max(bounds.high, boxes_[order_[i]].high);
    }
    nodes_.push_back({bounds, first, count, 0});
    if (count <= leaf_size) return index;
    const glm::vec3 size = bounds.high - bounds.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const float middle_a = boxes_[a].low[axis] + boxes_[a].high[axis];
        const float middle_b = boxes_[b].low[axis] + boxes_[b].high[axis];
        return middle_a < middle_b || (middle_a == middle_b && a < b);
    });
    build(first, half);
    const std::uint32_t second = build(first + half, count - half);
    nodes_[index].second_child = second;
    return index;
}

std::vector<std::uint32_t> BoxTree::overlapping(const Box& box) const {
    std::vector<std::uint32_t> found, open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        const Node& node = nodes_[index];
        open.pop_back();
        if (!overlap(node.bounds, box)) continue;
        if (node.second_child != 0) {
            open.push_back(index + 1);
            open.push_back(node.second_child);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (overlap(boxes_[order_[i]], box)) found.push_back(order_[i]);
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace brewster
