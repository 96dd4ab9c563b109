#include "app/seen_point.h"

#include <array>

namespace brewster {

std::optional<Hit> seen_hit(const Rays& rays, glm::vec3 eye, glm::vec3 direction) {
    constexpr int most_backs = 64;
    std::array<Ray, 1> ray = {Ray{eye, direction, no_triangle}};
    std::array<Hit, 1> hit;
    for (int back = 0; back < most_backs; ++back) {
        rays.intersect(ray, hit);
        if (hit[0].escaped()) return std::nullopt;
        if (hit[0].chart != no_chart) return hit[0];
        ray[0].origin = hit[0].position;
        ray[0].leaving = hit[0].triangle;
    }
    return std::nullopt;
}

std::optional<glm::vec3> seen_point(const Rays& rays, glm::vec3 eye, glm::vec3 direction) {
    const std::optional<Hit> hit = seen_hit(rays, eye, direction);
    return hit ? std::optional(hit->position) : std::nullopt;
}

}  // namespace brewster
