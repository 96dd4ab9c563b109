#include "scene/smooth_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/units.h"
#include "scene/disjoint_sets.h"

namespace brewster {
namespace {

constexpr std::size_t few_facets = 512, many_facets = 8192;

double cosine_of_degrees(double angle) {
    return std::cos(radians(angle));
}

// For each vertex the first one at its position.
std::vector<std::uint32_t> welded(const std::vector<glm::vec3>& vertices) {
    constexpr std::uint32_t empty = 0xffffffffu;
    const std::size_t slots = std::bit_ceil(2 * vertices.size() + 1);
    std::vector<std::uint32_t> table(slots, empty), first(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        std::uint64_t key = 0x9e3779b97f4a7c15u;
        for (int k = 0; k < 3; ++k) {
            key = (key ^ std::bit_cast<std::uint32_t>(vertices[i][k] + 0.0f)) * 0xff51afd7ed558ccdu;  // -0 becomes 0
            key ^= key >> 32;
        }
        std::size_t slot = key & (slots - 1);
        while (table[slot] != empty && vertices[table[slot]] != vertices[i]) slot = (slot + 1) & (slots - 1);
        if (table[slot] == empty) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

struct HalfEdge {
    std::uint64_t ends;  // the lower vertex first
    std::uint32_t triangle;
    std::uint8_t corner;  // where it starts
    bool rising;          // from the lower to the higher vertex
};

std::vector<HalfEdge> half_edges(const std::vector<std::uint32_t>& weld,
                                 const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<HalfEdge> halves;
    halves.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint8_t k = 0; k < 3; ++k) {
            const std::uint64_t a = weld[triangles[t][k]], b = weld[triangles[t][(k + 1u) % 3u]];
            halves.push_back({std::min(a, b) << 32 | std::max(a, b), t, k, a < b});
        }
    }
    std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
    });
    return halves;
}

// The number of planes that edges without a bend leave.
std::size_t facet_count(std::size_t triangles, const std::vector<SmoothEdge>& edges) {
    DisjointSets sets(triangles);
    for (const SmoothEdge& edge : edges)
        if (!edge.bends) sets.join(edge.first, edge.second);
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < triangles; ++t) count += sets.find(t) == t;
    return count;
}

}  // namespace

std::vector<SmoothEdge> smooth_edges(const std::vector<glm::vec3>& vertices, const std::vector<glm::vec3>& normals,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                     const std::vector<glm::vec3>& facet_normals) {
    // Small angles by their sine: the cosine of 0.1 degree is 1 within a few units in the last place.
    const double same_plane = std::sin(radians(0.1)), same_normal = cosine_of_degrees(1);
    const double steepest = cosine_of_degrees(normals.empty() ? 60 : 75);
    std::vector<SmoothEdge> edges;
    const std::vector<HalfEdge> halves = half_edges(welded(vertices), triangles);
    for (std::size_t i = 0; i < halves.size();) {
        std::size_t end = i + 1;
        while (end < halves.size() && halves[end].ends == halves[i].ends) ++end;
        const HalfEdge& a = halves[i];
        const bool pair = end - i == 2 && a.rising != halves[i + 1].rising;
        i = end;
        if (!pair) continue;
        const HalfEdge& b = halves[end - 1];
        const glm::vec3 n = facet_normals[a.triangle], m = facet_normals[b.triangle];
        if (static_cast<double>(glm::dot(n, m)) < steepest) continue;
        const auto& t = triangles[a.triangle];
        const auto& s = triangles[b.triangle];
        const std::uint32_t a0 = t[a.corner], a1 = t[(a.corner + 1u) % 3u];
        const std::uint32_t b1 = s[b.corner], b0 = s[(b.corner + 1u) % 3u];  // it runs the other way
        if (!normals.empty() && (static_cast<double>(glm::dot(normals[a0], normals[b0])) < same_normal ||
                                 static_cast<double>(glm::dot(normals[a1], normals[b1])) < same_normal))
            continue;
        edges.push_back({a.triangle, b.triangle, glm::distance(vertices[a0], vertices[a1]),
                         static_cast<double>(glm::length(glm::cross(n, m))) > same_plane});
    }
    if (!normals.empty()) return edges;
    const std::size_t facets = facet_count(triangles.size(), edges);
    const double limit = cosine_of_degrees(10);
    std::erase_if(edges, [&](const SmoothEdge& edge) {
        if (!edge.bends || facets > many_facets) return false;
        const glm::vec3 n = facet_normals[edge.first], m = facet_normals[edge.second];
        return facets <= few_facets || static_cast<double>(glm::dot(n, m)) < limit;
    });
    return edges;
}

}  // namespace brewster
