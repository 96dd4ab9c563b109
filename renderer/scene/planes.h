#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace brewster {

/// Triangles of one plane that face the same way, and that plane: unit normal . position = offset.
struct PlaneGroup {
    std::vector<std::uint32_t> triangles;  ///< ascending
    glm::dvec3 normal{0.0};
    double offset = 0;
};

/// Sorts triangles into planes, connected or not: their normals agree within 0.1 degree and their corners lie within
/// `distance_tolerance` of the group's size of its plane. Each triangle is in one group; groups stand in the order of
/// their first triangles. On a curved mesh every facet becomes a group of its own. Triangles must have an area. Near
/// linear in the number of triangles: planes are found by a hash of normal and offset.
std::vector<PlaneGroup> plane_groups(const std::vector<glm::vec3>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                     double distance_tolerance = 1e-5);

}  // namespace brewster
