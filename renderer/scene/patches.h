#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/smooth_edges.h"

namespace brewster {

/// A connected piece of a curved surface that projects one-to-one on the plane across `axis`.
struct Patch {
    std::vector<std::uint32_t> triangles;  ///< ascending
    glm::dvec3 axis{0.0};                  ///< unit; no facet's normal is further from it than `widest_cone`
};

/// A sphere falls into six patches whose corners lie 54.7 degrees off; beyond 60 degrees the projection would stretch
/// areas by more than two.
inline constexpr double widest_cone = 60;  ///< degrees

/// Sorts the triangles that smooth edges join around bends into patches, by the side of a cube that their normal looks
/// at; patches next to each other become one as long as one cone holds the normals of both. So their number follows
/// the curvature and not the number of triangles. Triangles without a bend beside them are in no patch. O(n log n).
std::vector<Patch> curved_patches(const std::vector<glm::vec3>& vertices,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  const std::vector<glm::vec3>& facet_normals, const std::vector<SmoothEdge>& edges);

}  // namespace brewster
