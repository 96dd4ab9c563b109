#include "scene/chart.h"

#include <glm/geometric.hpp>

namespace brewster {

glm::vec2 Chart::unit_coordinates(glm::vec3 position) const {
    const glm::vec3 d = position - origin;
    return {(d.x * axis_u.x + d.y * axis_u.y + d.z * axis_u.z) / size_u,
            (d.x * axis_v.x + d.y * axis_v.y + d.z * axis_v.z) / size_v};
}

Frame Chart::frame_about(glm::vec3 to) const {
    if (to == normal) return frame();
    const glm::vec3 sum = (normal + to) / (1.0f + glm::dot(normal, to));
    return {axis_u - glm::dot(axis_u, to) * sum, axis_v - glm::dot(axis_v, to) * sum, to};
}

}  // namespace brewster
