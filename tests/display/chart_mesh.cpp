#include "display/chart_mesh.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "hand_made.h"

namespace brewster {
namespace {

glm::vec3 normal_of(const std::vector<ChartVertex>& vertices, std::size_t triangle) {
    const ChartVertex* v = &vertices[3 * triangle];
    return glm::normalize(glm::cross(v[1].position - v[0].position, v[2].position - v[0].position));
}

TEST(ChartVertices, SideWithoutChartIsLeftOut) {
    Scene scene;
    hand_made::add_rectangle(scene, {0, 0, 0}, {2, 0, 0}, {0, 3, 0}, Material{});
    const std::vector<ChartVertex> vertices = chart_vertices(scene);
    ASSERT_EQ(vertices.size(), 6u);
    for (const ChartVertex& vertex : vertices) {
        EXPECT_EQ(vertex.chart, 0u);
        EXPECT_EQ(vertex.unit_coordinates, glm::vec2(vertex.position.x / 2, vertex.position.y / 3));
    }
    EXPECT_EQ(normal_of(vertices, 0), glm::vec3(0, 0, 1));
}

TEST(ChartVertices, BackRunsTheOtherWay) {
    Scene scene;
    hand_made::add_rectangle(scene, {0, 0, 0}, {2, 0, 0}, {0, 3, 0}, Material{}, true);
    const std::vector<ChartVertex> vertices = chart_vertices(scene);
    ASSERT_EQ(vertices.size(), 12u);
    for (std::size_t triangle = 0; triangle < 4; ++triangle) {
        EXPECT_EQ(normal_of(vertices, triangle), scene.charts[vertices[3 * triangle].chart].normal);
    }
}

}  // namespace
}  // namespace brewster
