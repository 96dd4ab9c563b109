#include "engine/outlines.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace brewster {
namespace {

// True area over that of the projection.
double stretch_of(const Scene& scene, const Triangle& triangle, const std::array<glm::dvec2, 3>& corners,
                  glm::dvec2 size) {
    const glm::dvec3 a(scene.vertices[triangle.vertices[0]]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(scene.vertices[triangle.vertices[1]]) - a,
                                         glm::dvec3(scene.vertices[triangle.vertices[2]]) - a);
    const glm::dvec2 e1 = size * (corners[1] - corners[0]), e2 = size * (corners[2] - corners[0]);
    return glm::length(normal) / std::abs(e1.x * e2.y - e1.y * e2.x);
}

}  // namespace

std::vector<Outline> outlines_of(const Scene& scene) {
    std::vector<Outline> outlines;
    outlines.reserve(scene.charts.size());
    for (std::size_t index = 0; index < scene.charts.size(); ++index) {
        const Chart& chart = scene.charts[index];
        Outline outline;
        outline.size = {chart.size_u, chart.size_v};
        for (std::uint32_t t = 0; t < chart.triangle_count; ++t) {
            const Triangle& triangle = scene.triangles[chart.first_triangle + t];
            std::array<glm::dvec2, 3> corners;
            for (std::size_t corner = 0; corner < 3; ++corner)
                corners[corner] = glm::dvec2(chart.unit_coordinates(scene.vertices[triangle.vertices[corner]]));
            outline.triangles.push_back(corners);
            if (chart.curved) outline.stretch.push_back(stretch_of(scene, triangle, corners, outline.size));
        }
        if (index < scene.contacts.size()) {
            for (const Contact& contact : scene.contacts[index])
                outline.contacts.emplace_back(glm::dvec2(contact.from), glm::dvec2(contact.to));
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace brewster
