#include "display/chart_mesh.h"

#include <array>
#include <cstddef>

namespace brewster {

std::vector<ChartVertex> chart_vertices(const Scene& scene) {
    std::vector<ChartVertex> vertices;
    const auto append = [&](std::uint32_t chart, const std::array<std::uint32_t, 3>& corners) {
        if (chart == no_chart) return;
        for (const std::uint32_t corner : corners) {
            const glm::vec3 position = scene.vertices[corner];
            vertices.push_back({position, scene.charts[chart].unit_coordinates(position), chart});
        }
    };
    for (const Triangle& triangle : scene.triangles) {
        const auto& [a, b, c] = triangle.vertices;
        append(triangle.front_chart, {a, b, c});
        append(triangle.back_chart, {a, c, b});
    }
    return vertices;
}

ChartMesh::ChartMesh(const Scene& scene) : array_(VertexArray::create()), buffer_(Buffer::create()) {
    const std::vector<ChartVertex> vertices = chart_vertices(scene);
    vertex_count_ = static_cast<GLsizei>(vertices.size());
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(ChartVertex)), vertices.data(),
                 GL_STATIC_DRAW);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ChartVertex), offset(offsetof(ChartVertex, position)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ChartVertex),
                          offset(offsetof(ChartVertex, unit_coordinates)));
    glEnableVertexAttribArray(2);
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, sizeof(ChartVertex), offset(offsetof(ChartVertex, chart)));
}

void ChartMesh::draw() const {
    glBindVertexArray(array_.id());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, vertex_count_);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace brewster
