#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace brewster {

/// Three unit vectors, right-handed.
struct Frame {
    glm::vec3 u{1, 0, 0}, v{0, 1, 0}, normal{0, 0, 1};
};

/// One side of a planar set of triangles of one mesh and one material, or of a curved patch of them that projects
/// one-to-one on the plane of its rectangle, with orthonormal coordinates on that plane. u and v run over [0, 1] across
/// the bounding rectangle: position = origin + u size_u axis_u + v size_v axis_v, on a patch plus a height.
struct Chart {
    std::string mesh;       ///< the node's name
    std::string mesh_name;  ///< the mesh's own
    std::uint32_t material = 0;
    std::uint32_t surface = 0;  ///< front and back of one plane share it; a ray that leaves a chart skips it
    std::uint32_t first_triangle = 0, triangle_count = 0;  ///< in Scene::triangles
    glm::vec3 origin{0.0f};
    glm::vec3 axis_u{1, 0, 0}, axis_v{0, 1, 0}, normal{0, 0, 1};  ///< right-handed, unit
    float size_u = 1, size_v = 1;                                 ///< metres
    double area = 0;                                              ///< m2, of the triangles
    glm::vec3 sheet_x{0.0f}, sheet_y{0.0f};  ///< axes that a filter's angle counts by, unit, the same for both sides
    bool curved = false;                     ///< a patch: the triangles' own normals are within 60 degrees of `normal`

    glm::vec2 unit_coordinates(glm::vec3 position) const;  ///< (u, v); outside [0, 1] beyond the rectangle
    Frame frame() const { return {axis_u, axis_v, normal}; }

    /// The chart's axes, turned the shortest way (parallel transport, theory 4) with `normal` onto `to`, unit and not
    /// opposite to it.
    Frame frame_about(glm::vec3 to) const;

    float size() const { return size_u > size_v ? size_u : size_v; }  ///< metres, what relative tolerances refer to
};

/// [0, 1] -> 24-bit fixed point, the coordinates that bins descend by; what lies outside is clamped to the border.
/// The same arithmetic as fixed_point_of in shaders/shared/lookup.h.
inline std::uint32_t chart_fixed_point(float unit) {
    const float scaled = (unit < 0.0f ? 0.0f : unit > 1.0f ? 1.0f : unit) * 16777216.0f;
    return static_cast<std::uint32_t>(scaled < 16777215.0f ? scaled : 16777215.0f);
}

/// A straight line on a chart, in its (u, v), along which another surface touches or crosses it.
struct Contact {
    glm::vec2 from, to;
};

}  // namespace brewster
