#include "app/seen_point.h"

#include <array>

#include "gather/first_look.h"

namespace brewster {

std::optional<Hit> seen_hit(const Rays& rays, glm::vec3 eye, glm::vec3 direction) {
    const std::array<Ray, 1> ray = {Ray{eye, direction, no_triangle}};
    std::array<Hit, 1> hit;
    rays.intersect(ray, hit);
    look_past_backs(rays, ray, hit);
    return hit[0].escaped() || hit[0].chart == no_chart ? std::nullopt : std::optional(hit[0]);
}

std::optional<glm::vec3> seen_point(const Rays& rays, glm::vec3 eye, glm::vec3 direction) {
    const std::optional<Hit> hit = seen_hit(rays, eye, direction);
    return hit ? std::optional(hit->position) : std::nullopt;
}

}  // namespace brewster
