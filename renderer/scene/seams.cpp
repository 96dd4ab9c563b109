#include "scene/seams.h"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace brewster {
namespace {

// Two points by their bits, in a fixed order, so that both directions of an edge are one key.
using Edge = std::array<std::uint32_t, 6>;

std::array<std::uint32_t, 3> bits(glm::vec3 p) {
    p += 0.0f;  // -0 becomes 0
    return {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y), std::bit_cast<std::uint32_t>(p.z)};
}

Edge edge_between(glm::vec3 a, glm::vec3 b) {
    auto first = bits(a), second = bits(b);
    if (second < first) std::swap(first, second);
    return {first[0], first[1], first[2], second[0], second[1], second[2]};
}

struct EdgeHash {
    std::size_t operator()(const Edge& edge) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15u;
        for (const std::uint32_t word : edge) {
            hash = (hash ^ word) * 0xff51afd7ed558ccdu;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

}  // namespace

std::vector<Seam> open_seams(const Scene& scene) {
    const auto corner = [&scene](const Triangle& triangle, std::size_t k) {
        return scene.vertices[triangle.vertices[k % 3]];
    };
    std::unordered_map<Edge, int, EdgeHash> uses;
    for (const Triangle& triangle : scene.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[edge_between(corner(triangle, k), corner(triangle, k + 1))];

    std::vector<Seam> seams;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        const Triangle& triangle = scene.triangles[t];
        const glm::dvec3 normal(scene.charts[triangle.front_chart].normal);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a(corner(triangle, k)), b(corner(triangle, k + 1)), c(corner(triangle, k + 2));
            if (uses[edge_between(glm::vec3(a), glm::vec3(b))] > 1) continue;
            const double length = glm::length(b - a);
            const double height = glm::length(glm::cross(b - a, c - a)) / length;
            const double width = static_cast<double>(triangle.margin[static_cast<int>((k + 2) % 3)]) * height;
            const glm::dvec3 along = (b - a) * (width / length);
            const glm::dvec3 out = glm::cross(along, normal);
            seams.push_back({{glm::vec3(a - along - out), glm::vec3(b + along - out), glm::vec3(b + along + out),
                              glm::vec3(a - along + out)},
                             t});
        }
    }
    return seams;
}

}  // namespace brewster
