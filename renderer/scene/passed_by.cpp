#include "scene/passed_by.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/planes.h"

namespace brewster {
namespace {

// The planes that flat surfaces lie in, either way up: a ray that leaves one surface of a plane cannot meet another.
std::vector<std::uint32_t> planes_of_surfaces(const Scene& scene, std::uint32_t curved) {
    constexpr double same_plane = 1e-6;  // of the size
    std::vector<std::uint32_t> planes;
    std::vector<glm::vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> halves;  // two of each flat surface's rectangle
    std::vector<std::uint32_t> flat;                   // surfaces
    for (const Chart& chart : scene.charts) {
        if (chart.surface != planes.size()) continue;  // a back
        planes.push_back(curved);
        if (chart.curved) continue;
        flat.push_back(chart.surface);
        const glm::vec3 u = chart.size_u * chart.axis_u, v = chart.size_v * chart.axis_v, n = chart.normal;
        const bool turned = n.x < 0 || (n.x == 0 && (n.y < 0 || (n.y == 0 && n.z < 0)));
        const auto first = static_cast<std::uint32_t>(corners.size());
        for (const glm::vec3& corner : {chart.origin, chart.origin + u, chart.origin + u + v, chart.origin + v})
            corners.push_back(corner);
        for (const std::uint32_t k : {1u, 2u})
            halves.push_back({first, first + (turned ? k + 1 : k), first + (turned ? k : k + 1)});
    }
    std::uint32_t plane = 0;
    for (const PlaneGroup& group : plane_groups(corners, halves, same_plane)) {
        for (const std::uint32_t half : group.triangles) planes[flat[half / 2]] = plane;
        ++plane;
    }
    return planes;
}

}  // namespace

PassedBy::PassedBy(const Scene& scene) : scene_(scene) {
    const std::vector<std::uint32_t> of_surfaces = planes_of_surfaces(scene, curved);
    planes_.reserve(scene.triangles.size());
    for (const Triangle& triangle : scene.triangles) planes_.push_back(of_surfaces[triangle.surface]);
}

bool PassedBy::is_neighbour_from_behind(std::uint32_t triangle, std::uint32_t leaving, glm::vec3 direction) const {
    glm::vec3 met[3], left[3];
    for (std::size_t k = 0; k < 3; ++k) {
        met[k] = scene_.vertices[scene_.triangles[triangle].vertices[k]];
        left[k] = scene_.vertices[scene_.triangles[leaving].vertices[k]];
    }
    // Left at the front and met at the back, or the other way round: both fronts look to one side of the ray.
    const bool met_back = glm::dot(glm::cross(met[1] - met[0], met[2] - met[0]), direction) > 0;
    const bool left_front = glm::dot(glm::cross(left[1] - left[0], left[2] - left[0]), direction) > 0;
    if (met_back != left_front) return false;
    return std::any_of(met, met + 3,
                       [&left](glm::vec3 corner) { return std::find(left, left + 3, corner) != left + 3; });
}

}  // namespace brewster
