#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "scene/planes.h"

namespace brewster {

/// What the vertices of a mesh carry, interpolated across its triangles.
struct VertexLook {
    std::span<const glm::vec3> normals;              ///< none: the mesh is flat
    std::span<const glm::vec2> texture_coordinates;  ///< none: no texture is used
    std::span<const glm::vec4> colors;               ///< none: white
};

/// The triangles of a plane, as few as its outline and its holes need where a modelling tool has cut it into more:
/// polygons are cut anew between their corners, without the vertices inside them and those within `tolerance` (metres)
/// of their straight edges. What edges join is one piece; a piece stays as it is where it has more than 64 corners,
/// meets itself in one, or where what the vertices carry is not linear over the new triangles; a plane does where
/// triangles overlap along an edge. In the order of the pieces' first triangles. Near linear in the number of
/// triangles.
std::vector<std::array<std::uint32_t, 3>> merged_triangles(const std::vector<glm::vec3>& vertices,
                                                           const VertexLook& look,
                                                           const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                           const PlaneGroup& plane, double tolerance);

}  // namespace brewster
