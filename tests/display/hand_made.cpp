#include "hand_made.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "shared/bin_layout.h"

namespace brewster::hand_made {
namespace {

void add_chart(Scene& scene, glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v, std::uint32_t surface) {
    Chart chart;
    chart.mesh = "rectangle " + std::to_string(surface);
    chart.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    chart.surface = surface;
    chart.first_triangle = 2 * surface;
    chart.triangle_count = 2;
    chart.origin = corner;
    chart.size_u = glm::length(edge_u);
    chart.size_v = glm::length(edge_v);
    chart.axis_u = edge_u / chart.size_u;
    chart.axis_v = edge_v / chart.size_v;
    chart.normal = glm::cross(chart.axis_u, chart.axis_v);
    chart.area = static_cast<double>(chart.size_u * chart.size_v);
    scene.charts.push_back(chart);
}

std::uint32_t grow(Snapshot& bins, std::uint32_t place, std::array<std::uint32_t, 4> cell, int leaves,
                   std::mt19937& random) {
    const auto uniform = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    const std::uint32_t axis = uniform(0, 1) < 0.5f ? 0 : 1;
    const std::uint32_t low = cell[2 * axis], high = cell[2 * axis + 1];
    if (leaves < 2 || high - low < 8) {
        const auto value = [&] { return uniform(1, 10); };
        bins.nodes[place] = add_leaf(bins, {value(), value(), value(), value()}, uniform(0, 1));
        return place;
    }
    const auto split = low + static_cast<std::uint32_t>(uniform(0.2f, 0.8f) * static_cast<float>(high - low));
    const int low_leaves = std::max(1, static_cast<int>(uniform(0.2f, 0.8f) * static_cast<float>(leaves)));
    const auto child = static_cast<std::uint32_t>(bins.nodes.size());
    bins.nodes.resize(bins.nodes.size() + 2);
    bins.nodes[place] = {split, axis << BREWSTER_NODE_AXIS_SHIFT | child};
    std::array<std::uint32_t, 4> low_cell = cell, high_cell = cell;
    low_cell[2 * axis + 1] = split;
    high_cell[2 * axis] = split;
    grow(bins, child, low_cell, low_leaves, random);
    grow(bins, child + 1, high_cell, leaves - low_leaves, random);
    return place;
}

}  // namespace

std::uint32_t add_rectangle(Scene& scene, glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v,
                            const Material& material, bool double_sided) {
    const auto vertex = static_cast<std::uint32_t>(scene.vertices.size());
    const auto chart = static_cast<std::uint32_t>(scene.charts.size());
    const auto surface = static_cast<std::uint32_t>(scene.triangles.size() / 2);
    scene.materials.push_back(material);
    for (const glm::vec3 place : {corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v}) {
        scene.vertices.push_back(place);
    }
    add_chart(scene, corner, edge_u, edge_v, surface);
    if (double_sided) add_chart(scene, corner, edge_v, edge_u, surface);
    for (const std::uint32_t last : {2u, 3u}) {
        Triangle triangle;
        triangle.vertices = {vertex, vertex + last - 1, vertex + last};
        triangle.front_chart = chart;
        if (double_sided) triangle.back_chart = chart + 1;
        triangle.surface = surface;
        scene.triangles.push_back(triangle);
    }
    return chart;
}

void close(Scene& scene) {
    scene.name = "hand-made";
    scene.low = scene.high = scene.vertices.front();
    for (const glm::vec3 vertex : scene.vertices) {
        scene.low = glm::min(scene.low, vertex);
        scene.high = glm::max(scene.high, vertex);
    }
}

glm::uvec2 add_leaf(Snapshot& bins, const std::array<float, 4>& corners, float standard_error) {
    const auto leaf = static_cast<std::uint32_t>(bins.leaves.size() / BREWSTER_LEAF_TEXELS);
    const glm::vec3 bands(1.0f, 0.5f, 0.25f);
    for (int k = 0; k < 4; ++k) {
        const float error = k < 3 ? standard_error * bands[k] : 0.0f;
        bins.leaves.emplace_back(corners[static_cast<std::size_t>(k)] * bands, error);
    }
    return {0u, BREWSTER_NODE_LEAF | leaf};
}

Snapshot empty_bins(const Scene& scene) {
    Snapshot bins;
    bins.version = 1;
    for (std::size_t i = 0; i < scene.charts.size(); ++i) {
        ChartBins chart;
        chart.direct_root = static_cast<std::uint32_t>(bins.nodes.size());
        chart.indirect_root = chart.direct_root + 1;
        chart.direct_leaves = chart.indirect_leaves = 1;
        bins.nodes.push_back(add_leaf(bins, {0, 0, 0, 0}, 0));
        bins.nodes.push_back(add_leaf(bins, {0, 0, 0, 0}, 0));
        bins.charts.push_back(chart);
    }
    return bins;
}

std::uint32_t add_random_tree(Snapshot& bins, int leaves, std::mt19937& random) {
    const auto root = static_cast<std::uint32_t>(bins.nodes.size());
    bins.nodes.emplace_back();
    return grow(bins, root, {0u, BREWSTER_UV_ONE, 0u, BREWSTER_UV_ONE}, leaves, random);
}

}  // namespace brewster::hand_made
