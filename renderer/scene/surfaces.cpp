#include "scene/surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/bounding_rectangle.h"
#include "scene/merged_triangles.h"
#include "scene/patches.h"
#include "scene/planes.h"
#include "scene/smooth_edges.h"

namespace brewster {
namespace {

// Below this height, relative to the longest edge, a triangle of floats has no plane to speak of.
constexpr double flattest = 1e-7;

struct Shape {
    glm::dvec3 edges;  ///< lengths, opposite to each vertex
    double area;
};

Shape shape_of(const std::vector<glm::vec3>& vertices, const std::array<std::uint32_t, 3>& triangle) {
    const glm::dvec3 a(vertices[triangle[0]]), b(vertices[triangle[1]]), c(vertices[triangle[2]]);
    return {{glm::length(c - b), glm::length(a - c), glm::length(b - a)}, 0.5 * glm::length(glm::cross(b - a, c - a))};
}

bool has_area(const Shape& shape) {
    const double longest = std::max({shape.edges.x, shape.edges.y, shape.edges.z});
    return 2.0 * shape.area > flattest * longest * longest;
}

// What becomes a chart: a plane, or a patch with the plane that it is projected on.
struct Group {
    PlaneGroup plane;
    bool curved = false;
};

std::vector<glm::vec3> facet_normals(const std::vector<glm::vec3>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<glm::vec3> normals;
    normals.reserve(triangles.size());
    for (const auto& triangle : triangles) {
        const glm::dvec3 a(vertices[triangle[0]]), b(vertices[triangle[1]]), c(vertices[triangle[2]]);
        normals.emplace_back(glm::normalize(glm::cross(b - a, c - a)));
    }
    return normals;
}

// The plane across a patch's axis, in the middle of its corners' heights.
Group group_of(Patch&& patch, const std::vector<glm::vec3>& vertices,
               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    double low = INFINITY, high = -INFINITY;
    for (const std::uint32_t t : patch.triangles)
        for (const std::uint32_t vertex : triangles[t]) {
            const double height = glm::dot(patch.axis, glm::dvec3(vertices[vertex]));
            low = std::min(low, height);
            high = std::max(high, height);
        }
    return {{std::move(patch.triangles), patch.axis, 0.5 * (low + high)}, true};
}

// Patches of what is curved, planes of the rest, in the order of their first triangles.
std::vector<Group> groups_of(const Part& part, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const std::vector<glm::vec3> normals = facet_normals(part.vertices, triangles);
    std::vector<Group> groups;
    std::vector<bool> in_patch(triangles.size(), false);
    for (Patch& patch : curved_patches(part.vertices, triangles, normals,
                                       smooth_edges(part.vertices, part.normals, triangles, normals))) {
        for (const std::uint32_t t : patch.triangles) in_patch[t] = true;
        groups.push_back(group_of(std::move(patch), part.vertices, triangles));
    }
    std::vector<std::array<std::uint32_t, 3>> flat;
    std::vector<std::uint32_t> index;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (in_patch[t]) continue;
        flat.push_back(triangles[t]);
        index.push_back(t);
    }
    for (PlaneGroup& plane : plane_groups(part.vertices, flat)) {
        for (std::uint32_t& t : plane.triangles) t = index[t];
        groups.push_back({std::move(plane), false});
    }
    std::sort(groups.begin(), groups.end(),
              [](const Group& a, const Group& b) { return a.plane.triangles[0] < b.plane.triangles[0]; });
    return groups;
}

// The node's x axis along the plane; where that stands across it, the y axis.
void set_sheet_axes(Chart& chart, const Part& part, const glm::dvec3& normal) {
    const auto along = [&](const glm::dvec3& axis) { return axis - glm::dot(axis, normal) * normal; };
    const glm::dvec3 first = along(part.axis_x);
    const glm::dvec3 x = glm::length(first) > 1e-6 * glm::length(part.axis_x) ? first : along(part.axis_y);
    if (!(glm::length(x) > 0)) return;
    chart.sheet_x = glm::vec3(glm::normalize(x));
    chart.sheet_y = glm::vec3(glm::cross(normal, glm::normalize(x)));
}

// A right-handed frame on the plane with the smallest rectangle around the triangles.
Chart chart_of(const Part& part, const std::vector<std::array<std::uint32_t, 3>>& triangles, const Group& group) {
    const PlaneGroup& plane = group.plane;
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 lean = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(lean - glm::dot(lean, n) * n), y = glm::cross(n, x);
    std::vector<glm::dvec2> points;
    double area = 0;
    for (const std::uint32_t t : plane.triangles) {
        area += shape_of(part.vertices, triangles[t]).area;
        for (const std::uint32_t vertex : triangles[t]) {
            const glm::dvec3 p(part.vertices[vertex]);
            points.emplace_back(glm::dot(p, x), glm::dot(p, y));
        }
    }
    const BoundingRectangle box = smallest_rectangle(std::move(points));
    Chart chart;
    chart.mesh = part.node_name;
    chart.mesh_name = part.mesh_name;
    chart.material = part.material;
    chart.normal = glm::vec3(n);
    chart.axis_u = glm::vec3(box.axis.x * x + box.axis.y * y);
    chart.axis_v = glm::vec3(-box.axis.y * x + box.axis.x * y);
    chart.origin = glm::vec3(box.corner.x * x + box.corner.y * y + plane.offset * n);
    chart.size_u = static_cast<float>(box.length);
    chart.size_v = static_cast<float>(box.width);
    chart.area = area;
    chart.curved = group.curved;
    set_sheet_axes(chart, part, n);
    return chart;
}

// The other side: the same rectangle, axes exchanged to stay right-handed.
Chart back_of(Chart chart) {
    std::swap(chart.axis_u, chart.axis_v);
    std::swap(chart.size_u, chart.size_v);
    chart.normal = -chart.normal;
    return chart;
}

// The triangles of a chart, those of a plane as few as it needs.
std::vector<std::array<std::uint32_t, 3>> members_of(const Part& part,
                                                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                     const Group& group, double inset) {
    if (!group.curved)
        return merged_triangles(part.vertices, {part.normals, part.texture_coordinates, part.colors}, triangles,
                                group.plane, 0.5 * inset);
    std::vector<std::array<std::uint32_t, 3>> members;
    for (const std::uint32_t t : group.plane.triangles) members.push_back(triangles[t]);
    return members;
}

glm::vec3 margin_of(const Shape& shape, double delta) {
    glm::vec3 margin;
    for (int k = 0; k < 3; ++k) {
        const double height = 2.0 * shape.area / shape.edges[k];
        margin[k] = static_cast<float>(std::min(delta / height, 1.0 / 3.0));
    }
    return margin;
}

}  // namespace

double hit_inset(const Chart& chart) {
    const glm::vec3 far =
        glm::abs(chart.origin) + glm::abs(chart.size_u * chart.axis_u) + glm::abs(chart.size_v * chart.axis_v);
    return std::max(1e-6 * static_cast<double>(chart.size()),
                    0x1p-22 * static_cast<double>(std::max({far.x, far.y, far.z})));
}

std::size_t add_surfaces(Scene& scene, const Part& part) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& triangle : part.triangles)
        if (has_area(shape_of(part.vertices, triangle))) triangles.push_back(triangle);

    const auto first_vertex = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), part.vertices.begin(), part.vertices.end());
    if (!part.normals.empty() || !scene.normals.empty()) {
        scene.normals.resize(first_vertex, glm::vec3(0.0f));
        scene.normals.insert(scene.normals.end(), part.normals.begin(), part.normals.end());
        scene.normals.resize(scene.vertices.size(), glm::vec3(0.0f));
    }
    std::uint32_t surface = scene.triangles.empty() ? 0 : scene.triangles.back().surface + 1;
    for (const Group& group : groups_of(part, triangles)) {
        Chart front = chart_of(part, triangles, group);
        const std::vector<std::array<std::uint32_t, 3>> members = members_of(part, triangles, group, hit_inset(front));
        front.surface = surface++;
        front.first_triangle = static_cast<std::uint32_t>(scene.triangles.size());
        front.triangle_count = static_cast<std::uint32_t>(members.size());
        Triangle sides;
        sides.surface = front.surface;
        sides.front_chart = static_cast<std::uint32_t>(scene.charts.size());
        // The skin of a transparent body is met from inside as well.
        const Material& material = scene.materials[part.material];
        if (material.double_sided || material.base == Base::transparent) sides.back_chart = sides.front_chart + 1;
        for (const auto& triangle : members) {
            for (std::size_t k = 0; k < 3; ++k) sides.vertices[k] = first_vertex + triangle[k];
            sides.margin = margin_of(shape_of(part.vertices, triangle), hit_inset(front));
            scene.triangles.push_back(sides);
        }
        scene.charts.push_back(front);
        if (sides.back_chart != no_chart) scene.charts.push_back(back_of(front));
    }
    return part.triangles.size() - triangles.size();
}

}  // namespace brewster
