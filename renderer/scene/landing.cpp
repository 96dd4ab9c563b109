#include "scene/landing.h"

namespace brewster {

LandingTable::LandingTable(const Scene& scene) {
    for (const Triangle& triangle : scene.triangles) {
        const Chart& front = scene.charts[triangle.front_chart];
        LandingTriangle row;
        row.corner = scene.vertices[triangle.vertices[0]];
        row.edge1 = scene.vertices[triangle.vertices[1]] - row.corner;
        row.edge2 = scene.vertices[triangle.vertices[2]] - row.corner;
        row.margin = triangle.margin;
        row.normal = front.curved ? scene.facet_normal(triangle) : front.normal;
        row.front_chart = triangle.front_chart;
        row.back_chart = triangle.back_chart;
        row.cut_out = scene.materials[front.material].alpha_cutoff > 0;
        LandingNormals corners;
        for (std::size_t k = 0; k < 3 && !scene.normals.empty(); ++k) {
            corners.at[k] = scene.normals[triangle.vertices[k]];
            if (corners.at[k] != glm::vec3(0.0f)) row.smooth = 1;
        }
        triangles.push_back(row);
        if (!scene.normals.empty()) normals.push_back(corners);
    }
    for (const Chart& chart : scene.charts) {
        LandingChart row;
        row.origin = chart.origin;
        row.axis_u = chart.axis_u;
        row.axis_v = chart.axis_v;
        row.size_u = chart.size_u;
        row.size_v = chart.size_v;
        row.normal = chart.normal;
        charts.push_back(row);
    }
}

}  // namespace brewster
