#include "scene/walls.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "base/rows.h"
#include "scene/surfaces.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Scene& scene, std::uint32_t triangle) {
    const auto& v = scene.triangles[triangle].vertices;
    return {glm::dvec3(scene.vertices[v[0]]), glm::dvec3(scene.vertices[v[1]]), glm::dvec3(scene.vertices[v[2]])};
}

constexpr float widest_margin = 1e-4f;  // barycentric

bool may_be_wall(const Scene& scene, const Triangle& triangle) {
    // Edges are widened by the margin of hits: where that is not small beside the triangle, far from the scene's middle,
    // the widening would be seen.
    const glm::vec3& margin = triangle.margin;
    if (std::max({margin.x, margin.y, margin.z}) > widest_margin) return false;
    const Chart& chart = scene.charts[triangle.front_chart];
    return !chart.curved && scene.materials[chart.material].alpha_cutoff <= 0;
}

Vector<float> single(const glm::dvec3& v) {
    return float_vector(glm::vec3(v));
}

// The wall of a triangle whose first corner stands `turned` places behind the file's.
Wall wall_of(const Scene& scene, std::uint32_t triangle, std::uint32_t turned) {
    const Corners file = corners_of(scene, triangle);
    const glm::dvec3 a = file[turned % 3], u = file[(turned + 1) % 3] - a, v = file[(turned + 2) % 3] - a;
    const glm::dvec3 n = glm::cross(u, v);
    const glm::vec3& margin = scene.triangles[triangle].margin;
    const auto margin_of = [&](std::uint32_t k) { return margin[static_cast<int>((turned + k) % 3)]; };
    Wall wall;
    wall.corner = single(a);
    wall.normal = single(glm::normalize(n));
    wall.along_u = single(glm::cross(v, n) / glm::dot(u, glm::cross(v, n)));
    wall.along_v = single(glm::cross(u, n) / glm::dot(v, glm::cross(u, n)));
    wall.low_u = -margin_of(1);
    wall.low_v = -margin_of(2);
    wall.high_u = 1 + margin_of(1) + margin_of(0);
    wall.high_v = 1 + margin_of(2) + margin_of(0);
    wall.high_sum = 1 + margin_of(0);
    wall.area = 0.5 * glm::length(n);
    return wall;
}

// How the two triangles of a parallelogram are turned, if they are that.
std::optional<WallTriangles> parallelogram(const Scene& scene, std::uint32_t first, std::uint32_t second) {
    const Triangle &one = scene.triangles[first], &two = scene.triangles[second];
    if (one.front_chart != two.front_chart || one.back_chart != two.back_chart) return {};
    const Corners a = corners_of(scene, first), b = corners_of(scene, second);
    const double close = 0.25 * hit_inset(scene.charts[one.front_chart]);
    for (std::uint32_t i = 0; i < 3; ++i)
        for (std::uint32_t j = 0; j < 3; ++j) {
            const glm::dvec3 &p = a[(i + 1) % 3], &q = a[(i + 2) % 3];
            if (p != b[(j + 2) % 3] || q != b[(j + 1) % 3]) continue;
            if (glm::length(p + q - a[i] - b[j]) <= close) return WallTriangles{{first, second}, {i, j}};
        }
    return {};
}

struct Candidate {
    Wall wall;
    WallTriangles triangles;
};

// Triangles next to each other in the file are paired where they make up parallelograms.
std::vector<Candidate> candidates_of(const Scene& scene, const std::vector<std::uint32_t>& planes) {
    std::vector<Candidate> candidates;
    const auto count = static_cast<std::uint32_t>(scene.triangles.size());
    for (std::uint32_t t = 0; t < count; ++t) {
        if (!may_be_wall(scene, scene.triangles[t])) continue;
        std::optional<WallTriangles> pair;
        if (t + 1 < count && may_be_wall(scene, scene.triangles[t + 1])) pair = parallelogram(scene, t, t + 1);
        Candidate candidate{wall_of(scene, t, pair ? pair->turned[0] : 0), pair.value_or(WallTriangles{{t, t}, {}})};
        Wall& wall = candidate.wall;
        wall.plane = planes[t];
        if (pair) {
            const Wall other = wall_of(scene, t + 1, pair->turned[1]);
            wall.high_u = 1 - other.low_u;
            wall.high_v = 1 - other.low_v;
            wall.high_sum = 3;
            wall.area *= 2;
            ++t;
        }
        candidates.push_back(candidate);
    }
    return candidates;
}

// Measured in rooms of 6 to 384 equal walls: a wall costs .64 ns a ray, the tree 100 to 160, which is met at 215 walls.
constexpr std::size_t most_walls = 192;

// Of more, those stay that hold a fair share of all area, since the tree is asked anyway: a small one seldom answers.
void keep_large(std::vector<Candidate>& candidates) {
    double area = 0;
    for (const Candidate& candidate : candidates) area += candidate.wall.area;
    std::erase_if(candidates,
                  [&](const Candidate& candidate) { return candidate.wall.area * double{most_walls} < area; });
}

// What the rays of a batch know of their nearest walls so far.
struct Nearest {
    FloatLanes distance{INFINITY}, u{}, v{};
    WordLanes wall{0xffffffffu};
};

}  // namespace

Walls::Walls(const Scene& scene, const std::vector<std::uint32_t>& planes) {
    std::vector<Candidate> candidates = candidates_of(scene, planes);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.wall.area > b.wall.area; });
    if (candidates.size() > most_walls) keep_large(candidates);
    std::vector<bool> is_wall(scene.triangles.size());
    for (const Candidate& candidate : candidates) {
        add(candidate.wall, candidate.triangles);
        for (const std::uint32_t triangle : candidate.triangles.triangle) is_wall[triangle] = true;
    }
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
        if (!is_wall[t]) others_.push_back(t);
}

void Walls::add(const Wall& wall, const WallTriangles& triangles) {
    walls_.push_back(wall);
    for (const std::size_t half : {0u, 1u}) {
        triangle_.push_back(triangles.triangle[half]);
        turned_.push_back(triangles.turned[half]);
    }
}

void Walls::trace(std::span<const Ray> rays, const std::uint32_t* planes_left, TriangleHit* hits) const {
    static_assert(sizeof(Ray) == sizeof(Row));
    if (walls_.empty()) {
        std::fill_n(hits, rays.size(), TriangleHit{no_chart, INFINITY, 0, 0});
        return;
    }
    for (std::size_t first = 0; first < rays.size(); first += lane_count) {
        const std::size_t count = std::min<std::size_t>(lane_count, rays.size() - first);
        const auto ray_of = [&](int lane) { return first + std::min(static_cast<std::size_t>(lane), count - 1); };
        const Columns ray = load_columns([&](int lane) { return reinterpret_cast<const float*>(&rays[ray_of(lane)]); });
        const Vector<FloatLanes> origin{ray[0], ray[1], ray[2]}, direction{ray[3], ray[4], ray[5]};
        std::array<std::uint32_t, lane_count> planes;
        for (int lane = 0; lane < lane_count; ++lane)
            planes[static_cast<std::size_t>(lane)] = planes_left[ray_of(lane)];
        const WordLanes left = load_words(planes.data());

        Nearest nearest;
        for (std::uint32_t index = 0; index < walls_.size(); ++index) {
            const Wall& wall = walls_[index];
            const auto everywhere = [](const Vector<float>& v) {
                return Vector<FloatLanes>{FloatLanes(v.x), FloatLanes(v.y), FloatLanes(v.z)};
            };
            const Vector<FloatLanes> normal = everywhere(wall.normal);
            const Vector<FloatLanes> from_corner = origin - everywhere(wall.corner);
            const FloatLanes distance = -dot(normal, from_corner) / dot(normal, direction);
            const Vector<FloatLanes> place = add_scaled(distance, direction, from_corner);
            const FloatLanes u = dot(everywhere(wall.along_u), place), v = dot(everywhere(wall.along_v), place);
            const LaneMask met = distance >= 0 && distance < nearest.distance && u >= FloatLanes(wall.low_u) &&
                                 v >= FloatLanes(wall.low_v) && u <= FloatLanes(wall.high_u) &&
                                 v <= FloatLanes(wall.high_v) && u + v <= FloatLanes(wall.high_sum) &&
                                 !equal(left, WordLanes(wall.plane));
            nearest.distance = select(met, distance, nearest.distance);
            nearest.u = select(met, u, nearest.u);
            nearest.v = select(met, v, nearest.v);
            nearest.wall = select(met, WordLanes(index), nearest.wall);
        }

        // The second triangle of a parallelogram begins at the other end of its diagonal.
        const LaneMask missed = has_top_bit(nearest.wall);
        const LaneMask second = nearest.u + nearest.v > 1;
        const WordLanes entry =
            select(missed, WordLanes(0u), nearest.wall + nearest.wall + select(second, WordLanes(1u), WordLanes(0u)));
        const FloatLanes b = select(second, 1 - nearest.u, nearest.u), c = select(second, 1 - nearest.v, nearest.v);
        const FloatLanes a = 1 - b - c;
        const WordLanes turned = gather<1>(turned_.data(), entry);
        const LaneMask once = equal(turned, WordLanes(1u)), twice = equal(turned, WordLanes(2u));
        Columns answer{};
        answer[0] = floats_of(select(missed, WordLanes(no_chart), gather<1>(triangle_.data(), entry)));
        answer[1] = nearest.distance;
        answer[2] = select(once, a, select(twice, c, b));
        answer[3] = select(once, b, select(twice, a, c));
        std::array<Row, lane_count> rows;
        store_columns(answer, [&](int lane) { return rows[static_cast<std::size_t>(lane)].x.data(); });
        static_assert(sizeof(TriangleHit) == sizeof(Row) / 2);
        for (std::size_t lane = 0; lane < count; ++lane)
            std::memcpy(static_cast<void*>(&hits[first + lane]), &rows[lane], sizeof(TriangleHit));
    }
}

}  // namespace brewster
