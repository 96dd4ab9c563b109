#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "fuzz/promises.h"
#include "scene/scene.h"

namespace brewster {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool within(glm::vec3 v, float low, float high) {
    return glm::all(glm::greaterThanEqual(v, glm::vec3(low))) && glm::all(glm::lessThanEqual(v, glm::vec3(high)));
}

bool unit(glm::vec3 v) {
    return std::abs(glm::length(v) - 1.0f) < 1e-4f;
}

void check_chart(const Scene& scene, const Chart& chart) {
    promise(finite(chart.origin), "a chart's origin is finite");
    promise(unit(chart.axis_u) && unit(chart.axis_v) && unit(chart.normal), "a chart's axes are unit");
    promise(glm::length(glm::cross(chart.axis_u, chart.axis_v) - chart.normal) < 1e-3f, "they are right-handed");
    promise(chart.size_u > 0 && chart.size_v > 0 && std::isfinite(chart.size()), "a chart has a size");
    promise(chart.area > 0 && std::isfinite(chart.area), "a chart has an area");
    promise(chart.material < scene.materials.size(), "a chart has a material");
    promise(chart.triangle_count > 0 && chart.first_triangle + chart.triangle_count <= scene.triangles.size(),
            "a chart has triangles");
}

void check_triangle(const Scene& scene, const Triangle& triangle) {
    for (const std::uint32_t vertex : triangle.vertices)
        promise(vertex < scene.vertices.size(), "a triangle's vertices are there");
    promise(triangle.front_chart < scene.charts.size(), "a triangle's front is a chart");
    promise(triangle.back_chart == no_chart || triangle.back_chart < scene.charts.size(), "its back is one or none");
    promise(unit(scene.facet_normal(triangle)), "a triangle has a normal");
    promise(within(triangle.margin, 0, 1 / 3.0f), "a triangle has an inside");
}

void check_material(const Scene& scene, const Material& material) {
    promise(within(material.albedo, 0, 1), "albedo is a share");
    promise(within(material.emission, 0, 1e24f), "emission is finite");
    promise(within(material.interface.n, 0, 1e6f) && within(material.interface.k, 0, 1e6f), "n and k are finite");
    promise(material.interface.slope >= 0 && material.interface.slope <= static_cast<float>(steepest_slope),
            "m is simulated");
    promise(material.texture == no_texture || material.texture < scene.textures.size(), "its texture is there");
}

void check_lamp(const Lamp& lamp) {
    promise(within(lamp.power, 0, 1e37f), "a lamp's power is finite");
    promise(lamp.chart != no_chart || unit(lamp.direction), "a lamp looks somewhere");
    promise(glm::length(lamp.polarization) < 1.001f, "a lamp is at most polarized");
}

}  // namespace

void check_scene(const Scene& scene) {
    const glm::vec3 bound = glm::max(glm::abs(scene.low), glm::abs(scene.high)) * 1.0001f;
    for (const glm::vec3& vertex : scene.vertices)
        promise(finite(vertex) && glm::all(glm::lessThanEqual(glm::abs(vertex), bound)), "vertices are within bounds");
    for (const glm::vec3& normal : scene.normals)
        promise(normal == glm::vec3(0.0f) || unit(normal), "normals are unit, or none");
    promise(!scene.triangles.empty() && !scene.charts.empty() && !scene.cameras.empty(), "there is something to see");
    promise(scene.normals.empty() || scene.normals.size() == scene.vertices.size(), "normals are the vertices'");
    promise(scene.contacts.size() == scene.charts.size(), "contacts are the charts'");
    for (const Chart& chart : scene.charts) check_chart(scene, chart);
    for (const Triangle& triangle : scene.triangles) check_triangle(scene, triangle);
    for (const Material& material : scene.materials) check_material(scene, material);
    for (const Lamp& lamp : scene.lamps) check_lamp(lamp);
    for (const Camera& camera : scene.cameras)
        promise(finite(camera.position) && unit(camera.forward) && unit(camera.up), "a camera looks somewhere");
}

}  // namespace brewster
