#include "scene/exact_hit.h"

#include <glm/geometric.hpp>

namespace brewster {

// Moeller and Trumbore 1997.
std::optional<TriangleHit> exact_hit(const Scene& scene, std::uint32_t index, glm::vec3 origin, glm::vec3 direction) {
    const Triangle& triangle = scene.triangles[index];
    const glm::dvec3 a(scene.vertices[triangle.vertices[0]]), d(direction);
    const glm::dvec3 e1 = glm::dvec3(scene.vertices[triangle.vertices[1]]) - a;
    const glm::dvec3 e2 = glm::dvec3(scene.vertices[triangle.vertices[2]]) - a;
    const glm::dvec3 p = glm::cross(d, e2), s = glm::dvec3(origin) - a, q = glm::cross(s, e1);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0) return {};
    const double b1 = glm::dot(s, p) / determinant, b2 = glm::dot(d, q) / determinant;
    const double distance = glm::dot(e2, q) / determinant;
    const glm::dvec3 margin = 4.0 * glm::dvec3(triangle.margin);
    if (distance < 0 || 1 - b1 - b2 < -margin.x || b1 < -margin.y || b2 < -margin.z) return {};
    return TriangleHit{index, static_cast<float>(distance), static_cast<float>(b1), static_cast<float>(b2)};
}

}  // namespace brewster
