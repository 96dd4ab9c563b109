#include "scene/mesh_boxes.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <map>

#include "base/rows.h"

namespace brewster {
namespace {

constexpr std::size_t most_boxes = 8;
constexpr float slack = 1e-5f;  // of the scene's radius: more than any rounding of what follows

}  // namespace

MeshBoxes::MeshBoxes(const Scene& scene, const std::vector<std::uint32_t>& triangles) {
    std::map<std::string, Box> of_mesh;
    Box all{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest())};
    const Box nothing = all;
    const auto grow = [&](Box& box, const Triangle& triangle) {
        for (const std::uint32_t vertex : triangle.vertices) {
            box.low = glm::min(box.low, scene.vertices[vertex] - slack * scene.radius());
            box.high = glm::max(box.high, scene.vertices[vertex] + slack * scene.radius());
        }
    };
    for (const std::uint32_t index : triangles) {
        const Triangle& triangle = scene.triangles[index];
        grow(all, triangle);
        grow(of_mesh.emplace(scene.charts[triangle.front_chart].mesh, nothing).first->second, triangle);
    }
    if (of_mesh.size() > most_boxes) {
        boxes_.push_back(all);
        return;
    }
    for (const auto& [name, box] : of_mesh) boxes_.push_back(box);
}

std::span<const std::uint32_t> MeshBoxes::crossed_by(std::span<const Ray> rays, std::span<const TriangleHit> hits,
                                                     std::span<std::uint32_t> places) const {
    std::size_t crossing = 0;
    for (std::size_t first = 0; first < rays.size(); first += lane_count) {
        const std::size_t count = std::min<std::size_t>(lane_count, rays.size() - first);
        const auto ray_of = [&](int lane) { return first + std::min(static_cast<std::size_t>(lane), count - 1); };
        const Columns ray = load_columns([&](int lane) { return reinterpret_cast<const float*>(&rays[ray_of(lane)]); });
        std::array<float, lane_count> distances;
        for (int lane = 0; lane < lane_count; ++lane)
            distances[static_cast<std::size_t>(lane)] = hits[ray_of(lane)].distance;
        const FloatLanes distance = load<FloatLanes>(distances.data());
        const std::array<FloatLanes, 3> inverse = {1 / ray[3], 1 / ray[4], 1 / ray[5]};
        LaneMask crosses = first_lanes(0);
        for (const Box& box : boxes_) {
            FloatLanes enter(0.0f), leave = distance;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int a = static_cast<int>(axis);
                const FloatLanes low = (FloatLanes(box.low[a]) - ray[axis]) * inverse[axis];
                const FloatLanes high = (FloatLanes(box.high[a]) - ray[axis]) * inverse[axis];
                enter = max(min(low, high), enter);
                leave = min(max(low, high), leave);
            }
            crosses = crosses || !(enter > leave);
        }
        const unsigned bits = bits_of(crosses);
        for (unsigned lane = 0; lane < count; ++lane) {
            places[crossing] = static_cast<std::uint32_t>(first + lane);
            crossing += bits >> lane & 1u;
        }
    }
    return {places.data(), crossing};
}

}  // namespace brewster
