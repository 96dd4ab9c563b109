#include "display/chart_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace brewster {

namespace {

std::uint32_t texture_of(const Scene& scene, const Triangle& triangle) {
    return scene.materials[scene.charts[triangle.front_chart].material].texture;
}

std::array<std::uint16_t, 4> stored(glm::vec4 color) {
    std::array<std::uint16_t, 4> whole{};
    for (int k = 0; k < 4; ++k)
        whole[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(std::lround(65535.0f * color[k]));
    return whole;
}

}  // namespace

std::vector<ChartVertex> chart_vertices(const Scene& scene) {
    std::vector<std::uint32_t> order(scene.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return texture_of(scene, scene.triangles[a]) < texture_of(scene, scene.triangles[b]);
    });
    std::vector<ChartVertex> vertices;
    const auto append = [&](std::uint32_t chart, const std::array<std::uint32_t, 3>& corners) {
        if (chart == no_chart) return;
        for (const std::uint32_t corner : corners) {
            const glm::vec3 position = scene.vertices[corner];
            vertices.push_back({position, scene.charts[chart].unit_coordinates(position), chart});
            if (!scene.texture_coordinates.empty())
                vertices.back().texture_coordinates = scene.texture_coordinates[corner];
            if (!scene.vertex_colors.empty()) vertices.back().color = stored(scene.vertex_colors[corner]);
        }
    };
    for (const std::uint32_t index : order) {
        const Triangle& triangle = scene.triangles[index];
        const auto& [a, b, c] = triangle.vertices;
        append(triangle.front_chart, {a, b, c});
        append(triangle.back_chart, {a, c, b});
    }
    return vertices;
}

std::vector<ChartGroup> chart_groups(const Scene& scene, const std::vector<ChartVertex>& vertices) {
    std::vector<ChartGroup> groups;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::uint32_t texture = scene.materials[scene.charts[vertices[i].chart].material].texture;
        if (groups.empty() || groups.back().texture != texture) groups.push_back({texture, static_cast<GLint>(i), 0});
        ++groups.back().count;
    }
    return groups;
}

ChartMesh::ChartMesh(const Scene& scene) : array_(VertexArray::create()), buffer_(Buffer::create()) {
    const std::vector<ChartVertex> vertices = chart_vertices(scene);
    groups_ = chart_groups(scene, vertices);
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
    glEnableVertexAttribArray(3);
    glVertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, sizeof(ChartVertex),
                          offset(offsetof(ChartVertex, texture_coordinates)));
    glEnableVertexAttribArray(4);
    glVertexAttribPointer(4, 4, GL_UNSIGNED_SHORT, GL_TRUE, sizeof(ChartVertex), offset(offsetof(ChartVertex, color)));
}

void ChartMesh::draw(const ChartGroup& group) const {
    glBindVertexArray(array_.id());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, group.first, group.count);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace brewster
