#pragma once
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/gltf_file.h"

namespace brewster {

/// Vertices and triangles of one primitive in world coordinates, double, before the scene is recentred. Only vertices
/// that a triangle names are there.
struct PlacedPrimitive {
    std::vector<glm::dvec3> vertices;
    std::vector<glm::vec3> normals;              ///< of the vertices, unit; none: flat, facet by facet
    std::vector<glm::vec2> texture_coordinates;  ///< of the vertices, as the file has them; none: it has not
    std::vector<glm::vec4> colors;               ///< of the vertices, linear, [0, 1]; none: white
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t mended_normals = 0;  ///< had no length; the mean of the facets around them stands in
};

/// Triangles of a primitive, from its corners and its mode; 0 for points and lines.
std::size_t triangle_count(const GltfFile& file, const GltfPrimitive& primitive);

/// Triangle t of a list, strip or fan, as numbers of corners, each triangle's front counter-clockwise (glTF 2.0, 3.7.2.1).
std::array<std::size_t, 3> triangle_corners(int mode, std::size_t t);

/// How a mesh stands: by its node, or, where it wears a skin, by its joints alone (glTF 2.0, 3.7.3.3: the node's own
/// transform is ignored).
struct MeshPlace {
    glm::dmat4 to_world{1.0};
    std::vector<glm::dmat4> joints;  ///< world transform times inverse bind matrix; none: no skin
};

/// Places a validated primitive with the texture coordinates of that set. Normals are transformed by the inverse
/// transpose; a mirroring transform turns the triangles, so that fronts stay fronts. Normals that are those of the
/// facets everywhere are left out.
PlacedPrimitive place_primitive(const GltfFile& file, const GltfPrimitive& primitive, const MeshPlace& place,
                                int texture_set);

}  // namespace brewster
