#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "scene/scene.h"

namespace brewster {

/// A hit by index and barycentric coordinates (as in Scene::point_inside).
struct TriangleHit {
    std::uint32_t triangle = no_chart;
    float distance = 0, b1 = 0, b2 = 0;
};

/// The nearest triangle that `accept(index)` allows, searched one by one in double precision; a triangle reaches as far
/// beyond its edges as hits are pulled inside. For the one ray in a million that single precision cannot decide.
template <class Accept>
std::optional<TriangleHit> nearest_exact(const Scene& scene, glm::vec3 origin, glm::vec3 direction,
                                         const Accept& accept);

/// Where a line meets one triangle, if it does, in front of its origin.
std::optional<TriangleHit> exact_hit(const Scene& scene, std::uint32_t triangle, glm::vec3 origin, glm::vec3 direction);

template <class Accept>
std::optional<TriangleHit> nearest_exact(const Scene& scene, glm::vec3 origin, glm::vec3 direction,
                                         const Accept& accept) {
    std::optional<TriangleHit> nearest;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        if (!accept(t)) continue;
        const auto hit = exact_hit(scene, t, origin, direction);
        if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
    }
    return nearest;
}

}  // namespace brewster
