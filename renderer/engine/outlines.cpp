#include "engine/outlines.h"

namespace brewster {

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
