#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace brewster {

struct Box {
    glm::vec3 low, high;
};

/// Finds boxes that overlap a box: a binary tree, split at the median of the longest side.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box> boxes);

    /// Indices of all boxes that touch or overlap `box`, ascending.
    std::vector<std::uint32_t> overlapping(const Box& box) const;

  private:
    static constexpr std::uint32_t leaf_size = 4;
    struct Node {
        Box bounds;
        std::uint32_t first, count;  // of order_; the first child follows its parent
        std::uint32_t second_child;  // 0: a leaf
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace brewster
