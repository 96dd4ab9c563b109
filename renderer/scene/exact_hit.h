#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "scene/triangle_hit.h"

namespace brewster {

/// Where a line meets a triangle in front of its origin, in double precision. The triangle reaches
/// four times as far beyond its edges as hits are pulled inside (its margin): a start that was moved by that much still
/// meets what the start itself was aimed at.
std::optional<TriangleHit> exact_hit(const Scene& scene, std::uint32_t triangle, glm::vec3 origin, glm::vec3 direction);

/// The nearest such hit of all that `accept(hit)` allows, one by one: for the one ray in a million that single
/// precision cannot decide.
template <class Accept>
TriangleHit nearest_exact(const Scene& scene, glm::vec3 origin, glm::vec3 direction, const Accept& accept) {
    TriangleHit nearest;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        const auto hit = exact_hit(scene, t, origin, direction);
        if (hit && (!nearest.met() || hit->distance < nearest.distance) && accept(*hit)) nearest = *hit;
    }
    return nearest;
}

}  // namespace brewster
