#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// All triangles of one node and one material, in scene coordinates; the front is counter-clockwise.
struct Part {
    std::string node_name, mesh_name;
    std::uint32_t material = 0;
    std::vector<glm::vec3> vertices;
    std::vector<glm::vec3> normals;  ///< of the vertices, unit; none: the mesh is flat, facet by facet
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::span<const glm::vec2> texture_coordinates{};  ///< of the vertices; none: no texture is used
    std::span<const glm::vec4> colors{};               ///< of the vertices; none: white
    glm::dvec3 axis_x{1, 0, 0}, axis_y{0, 1, 0};       ///< of the node, in the scene: filters turn from them
};

/// Adds a part's vertices and triangles to the scene, patch by patch (scene/patches.h) and plane by plane, each with a
/// front chart and, if the material is double-sided or transparent, a back chart. Flat pieces are cut into as few
/// triangles as they need (scene/merged_triangles.h). Triangles without area are left out; their number is returned.
std::size_t add_surfaces(Scene& scene, const Part& part);

/// Metres: how far inside the edges of its triangles a hit on the chart lies. 1e-6 of the chart's size, but never less
/// than four units in the last place of its coordinates.
double hit_inset(const Chart& chart);

}  // namespace brewster
