#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace brewster {

/// Two triangles of a mesh that share an edge across which the surface goes on smoothly.
struct SmoothEdge {
    std::uint32_t first = 0, second = 0;
    float length = 0;    ///< metres
    bool bends = false;  ///< by more than 0.1 degree; otherwise both lie in a plane
};

/// The smooth edges of a mesh, in an order that depends on the mesh alone. Vertices of equal position count as one. An
/// edge joins exactly two triangles that face the same way round.
/// With vertex normals: those of both sides agree within a degree at both ends, and the facets within 75 degrees.
/// Without: facets are meant as they are, and none are joined, but in meshes of more than 512 facets those within 10
/// degrees, and of more than 8192 facets those within 60 degrees: there they approximate something curved, and one
/// chart each would cost as many bins as there are triangles.
/// `facet_normals`: unit, of each triangle.
std::vector<SmoothEdge> smooth_edges(const std::vector<glm::vec3>& vertices, const std::vector<glm::vec3>& normals,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                     const std::vector<glm::vec3>& facet_normals);

}  // namespace brewster
