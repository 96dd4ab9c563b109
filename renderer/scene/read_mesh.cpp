#include "scene/read_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/accessor.h"

namespace brewster {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;
constexpr float flat_within = 1e-3f;  // sine: normals this close to their facet's come from rounding, not from a curve

const GltfAccessor& accessor(const GltfFile& file, int index) {
    return file.accessors[static_cast<std::size_t>(index)];
}

const GltfAccessor& positions_of(const GltfFile& file, const GltfPrimitive& primitive) {
    return accessor(file, primitive.attributes.at("POSITION"));
}

std::size_t corner_count(const GltfFile& file, const GltfPrimitive& primitive) {
    return primitive.indices < 0 ? positions_of(file, primitive).count : accessor(file, primitive.indices).count;
}

// The inverse transpose but for a positive factor: its columns are cross products, so it exists for flat nodes, too.
glm::dmat3 normal_transform(const glm::dmat3& m) {
    const double sign = glm::determinant(m) < 0 ? -1.0 : 1.0;
    return {sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])};
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

// Twice the area long.
glm::dvec3 facet_normal(const PlacedPrimitive& part, const std::array<std::uint32_t, 3>& t) {
    return glm::cross(part.vertices[t[1]] - part.vertices[t[0]], part.vertices[t[2]] - part.vertices[t[0]]);
}

void mend_normals(PlacedPrimitive& part) {
    std::vector<glm::dvec3> means(part.vertices.size(), glm::dvec3(0.0));
    for (const auto& triangle : part.triangles)
        for (const std::uint32_t vertex : triangle) means[vertex] += facet_normal(part, triangle);
    for (std::size_t i = 0; i < part.normals.size(); ++i) {
        if (part.normals[i] != glm::vec3(0.0f)) continue;
        part.normals[i] = unit_or_zero(means[i]);
        // Facets that cancel, or none with an area: any direction is as good.
        if (part.normals[i] == glm::vec3(0.0f)) part.normals[i] = glm::vec3(0, 1, 0);
        ++part.mended_normals;
    }
}

bool is_flat(const PlacedPrimitive& part) {
    for (const auto& triangle : part.triangles) {
        const glm::vec3 facet = unit_or_zero(facet_normal(part, triangle));
        if (facet == glm::vec3(0.0f)) continue;
        for (const std::uint32_t vertex : triangle) {
            const glm::vec3 n = part.normals[vertex];
            if (glm::length(glm::cross(facet, n)) > flat_within || glm::dot(facet, n) < 0) return false;
        }
    }
    return true;
}

}  // namespace

std::size_t triangle_count(const GltfFile& file, const GltfPrimitive& primitive) {
    if (primitive.mode < gltf_triangles) return 0;
    const std::size_t corners = corner_count(file, primitive);
    if (primitive.mode == gltf_triangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

std::array<std::size_t, 3> triangle_corners(int mode, std::size_t t) {
    switch (mode) {
        case gltf_triangle_strip:
            return {t, t + 1 + t % 2, t + 2 - t % 2};
        case gltf_triangle_fan:
            return {t + 1, t + 2, 0};
        default:
            return {3 * t, 3 * t + 1, 3 * t + 2};
    }
}

PlacedPrimitive place_primitive(const GltfFile& file, const GltfPrimitive& primitive, const glm::dmat4& to_world) {
    const GltfAccessor& positions = positions_of(file, primitive);
    const auto found = primitive.attributes.find("NORMAL");
    const GltfAccessor* normals = found == primitive.attributes.end() ? nullptr : &accessor(file, found->second);
    const glm::dmat3 turned = normal_transform(glm::dmat3(to_world));
    const bool mirrored = glm::determinant(glm::dmat3(to_world)) < 0;

    PlacedPrimitive part;
    std::vector<std::uint32_t> placed(positions.count, unused);
    bool mend = false;
    const auto vertex = [&](std::size_t corner) {
        const std::uint32_t i = primitive.indices < 0 ? static_cast<std::uint32_t>(corner)
                                                      : read_index(file, accessor(file, primitive.indices), corner);
        if (placed[i] != unused) return placed[i];
        placed[i] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.emplace_back(to_world * glm::dvec4(glm::dvec3(read_vector(file, positions, i)), 1.0));
        if (normals) {
            part.normals.push_back(unit_or_zero(turned * glm::dvec3(read_vector(file, *normals, i))));
            mend = mend || part.normals.back() == glm::vec3(0.0f);
        }
        return placed[i];
    };
    const std::size_t count = triangle_count(file, primitive);
    for (std::size_t t = 0; t < count; ++t) {
        const std::array<std::size_t, 3> corners = triangle_corners(primitive.mode, t);
        std::array<std::uint32_t, 3> triangle = {vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
        if (mirrored) std::swap(triangle[1], triangle[2]);
        part.triangles.push_back(triangle);
    }
    if (mend) mend_normals(part);
    if (normals && is_flat(part)) part.normals.clear();
    return part;
}

}  // namespace brewster
