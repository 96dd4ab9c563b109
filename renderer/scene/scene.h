#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.h"
#include "scene/chart.h"
#include "scene/lamp.h"
#include "scene/material.h"

namespace brewster {

inline constexpr std::uint32_t no_chart = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint32_t no_surface = std::numeric_limits<std::uint32_t>::max();

/// A triangle and the charts of its two sides. The front is where the vertices run counter-clockwise.
/// A missing back absorbs every ray.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    std::uint32_t front_chart = no_chart, back_chart = no_chart;
    std::uint32_t surface = no_surface;
    glm::vec3 margin{0.0f};  ///< least barycentric coordinates of a hit: 1e-6 of the chart's size inside each edge
};

/// What a file describes, ready for light: constant once read. Coordinates are the file's minus `centre`.
struct Scene {
    std::string name;  ///< the file's stem
    glm::dvec3 centre{0.0};
    glm::vec3 low{0.0f}, high{0.0f};  ///< bounds after recentring
    std::vector<glm::vec3> vertices;
    std::vector<glm::vec3> normals;  ///< of the vertices, unit; zero: flat, facet by facet; none where all are flat
    std::vector<glm::vec2> texture_coordinates;  ///< of the vertices, ready for the texture; none where none is used
    std::vector<glm::vec4> vertex_colors;        ///< of the vertices, linear, [0, 1]; none where all are white
    std::vector<Triangle> triangles;             ///< those of one surface stand together
    std::vector<Chart> charts;
    std::vector<std::vector<Contact>> contacts;  ///< per chart
    std::vector<Material> materials;
    std::vector<SurfaceTexture> textures;
    std::vector<Lamp> lamps;
    std::vector<Camera> cameras;        ///< never empty: a file without one gets the view "fit"
    std::vector<std::string> warnings;  ///< what is not simulated or was mended, a sentence each

    float radius() const;  ///< of the sphere around the origin that holds the bounds

    /// The camera of that name; an unknown name is an Error that lists the names there are.
    const Camera& camera(const std::string& camera_name) const;

    /// The charts of the mesh of that name, both sides; an unknown name is an Error that lists the names there are.
    std::vector<std::uint32_t> charts_of(const std::string& mesh_name) const;

    /// One flag a chart: whether it is of that mesh; as charts_of.
    std::vector<bool> is_of(const std::string& mesh_name) const;

    /// Of each triangle of a chart, the share of the chart's area up to and with it; ends in 1.
    std::vector<double> area_shares(const Chart& chart) const;

    glm::vec3 total_power() const;  ///< of all lamps, lumen per band

    /// Unit, on the front; of the plane that the corners span.
    glm::vec3 facet_normal(const Triangle& triangle) const;

    /// The normal that shades the point b0 A + b1 B + b2 C: interpolated, unit, on the front; of a flat mesh, or where
    /// the corners' normals cancel or turn away from the facet, the facet's.
    glm::vec3 shading_normal(const Triangle& triangle, glm::vec3 facet_normal, float b1, float b2) const;

    /// The point b0 A + b1 B + b2 C of a triangle, b0 = 1 - b1 - b2, pulled inside its edges by its margin.
    glm::vec3 point_inside(const Triangle& triangle, float b1, float b2) const;
};

/// Reads a .gltf or .glb file. Throws Error in one sentence for a file that cannot be read or is not simulated.
Scene read_scene(const std::string& path);

/// The same from text already in memory (an embedded scene); `name` stands in messages, buffers must be data URIs.
Scene read_scene_text(std::string_view text, const std::string& name);

}  // namespace brewster
