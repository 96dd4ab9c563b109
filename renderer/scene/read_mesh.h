#pragma once
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/gltf_file.h"

namespace brewster {

/// Vertices and triangles of one primitive in world coordinates, double, before the scene is recentred. Only vertices
/// that a triangle names are there.
struct PlacedPrimitive {
    std::vector<glm::dvec3> vertices;
    std::vector<glm::vec3> normals;  ///< of the vertices, unit; none: flat, facet by facet
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t mended_normals = 0;  ///< had no length; the mean of the facets around them stands in
};

/// Triangles of a primitive, from its corners and its mode; 0 for points and lines.
std::size_t triangle_count(const GltfFile& file, const GltfPrimitive& primitive);

/// Triangle t of a list, strip or fan, as numbers of corners, each triangle's front counter-clockwise (glTF 2.0, 3.7.2.1).
std::array<std::size_t, 3> triangle_corners(int mode, std::size_t t);

/// Places a validated primitive. Normals are transformed by the inverse transpose; a mirroring transform turns the
/// triangles, so that fronts stay fronts. Normals that are those of the facets everywhere are left out.
PlacedPrimitive place_primitive(const GltfFile& file, const GltfPrimitive& primitive, const glm::dmat4& to_world);

}  // namespace brewster
