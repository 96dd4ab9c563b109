#pragma once
#include <glm/vec2.hpp>
#include <vector>

namespace brewster {

/// A rectangle in the plane: corner, unit vector along its first side, the second side a quarter turn to the left.
struct BoundingRectangle {
    glm::dvec2 corner{0.0}, axis{1.0, 0.0};
    double length = 0, width = 0;
};

/// The rectangle of smallest area around the points, one side along an edge of their convex hull (Freeman and Shapira
/// 1975); of rectangles within 1e-6 of the smallest, the one along the longest edge. O(n log n).
/// Points on one line give width 0.
BoundingRectangle smallest_rectangle(std::vector<glm::dvec2> points);

}  // namespace brewster
