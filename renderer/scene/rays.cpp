#include "scene/rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "scene/albedo.h"
#include "scene/exact_hit.h"
#include "scene/planes.h"
#include "scene/ray_tree.h"
#include "scene/surfaces.h"

namespace brewster {
namespace {

constexpr std::uint32_t no_plane = 0xffffffffu;

// What a second try needs to know of the surface a ray leaves.
struct Stand {
    glm::vec3 normal{0.0f}, middle{0.0f};
    float size = 0, inset = 0;
    std::uint32_t plane = no_plane;
};

// The planes that surfaces lie in, either way up: a ray that leaves one surface of a plane cannot meet another.
void set_planes(const Scene& scene, std::vector<Stand>& stands) {
    constexpr double same_plane = 1e-6;  // of the size
    std::vector<glm::vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> halves;  // two of each surface's rectangle
    for (const Chart& chart : scene.charts) {
        if (2 * chart.surface != halves.size()) continue;  // a back
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
        for (const std::uint32_t half : group.triangles) stands[half / 2].plane = plane;
        ++plane;
    }
}

std::vector<Stand> stands_of_surfaces(const Scene& scene) {
    std::vector<Stand> stands;
    for (const Chart& chart : scene.charts) {
        if (chart.surface != stands.size()) continue;  // a back
        const glm::vec3 diagonal = chart.size_u * chart.axis_u + chart.size_v * chart.axis_v;
        stands.push_back({chart.normal, chart.origin + 0.5f * diagonal, chart.size(),
                          static_cast<float>(hit_inset(chart)), no_plane});
    }
    set_planes(scene, stands);
    return stands;
}

std::vector<std::uint32_t> planes_of_triangles(const Scene& scene, const std::vector<Stand>& stands) {
    std::vector<std::uint32_t> planes;
    for (const Triangle& triangle : scene.triangles) planes.push_back(stands[triangle.surface].plane);
    return planes;
}

}  // namespace

struct Rays::Impl {
    explicit Impl(const Scene& whole)
        : scene(whole), stands(stands_of_surfaces(whole)), tree(whole, planes_of_triangles(whole, stands)) {}

    std::uint32_t plane_left(const Ray& ray) const {
        return ray.leaving == no_triangle ? no_plane : plane_of(ray.leaving);
    }

    // From the first answer to the hit; where that is nothing or a back, by a closer look.
    Hit finished(const Ray& ray, std::uint32_t plane, const TriangleHit& first) const {
        const Hit hit = hit_on(ray, first);
        if (hit.chart != no_chart || hit.hole) return hit;
        const Hit closer = hit_on(ray, closer_look(ray, plane, first));
        return closer.chart != no_chart ? closer : hit;
    }

    std::uint32_t plane_of(std::uint32_t triangle) const { return stands[scene.triangles[triangle].surface].plane; }

    // Single precision cannot decide for a ray that starts within rounding of its plane close to a wall's foot, that
    // runs along an edge, or that meets the gap, a few units in the last place wide, between a wall and another that
    // ends within its edge. A ray beside it, clear of all edges, shows which triangle it ought to meet; double
    // precision then says whether it does, counting what lies as close beside the triangle as hits are pulled inside.
    TriangleHit closer_look(const Ray& ray, std::uint32_t plane, const TriangleHit& first) const {
        constexpr float grazing = 0.01f;
        constexpr std::size_t few_triangles = 4096;
        Ray clear = ray, beside = ray;
        bool grazes = false;
        if (ray.leaving == no_triangle) {
            beside.origin += 1e-4f * scene.radius() * glm::vec3(ray.direction.y, ray.direction.z, ray.direction.x);
        } else {
            const Stand& stand = stands[scene.triangles[ray.leaving].surface];
            const float cosine = glm::dot(stand.normal, ray.direction);
            const glm::vec3 up = cosine < 0.0f ? -stand.normal : stand.normal;
            grazes = std::abs(cosine) < grazing;
            clear.origin += stand.inset * up;
            beside.origin += 1e-4f * stand.size * up + 1e-3f * (stand.middle - ray.origin);
        }
        TriangleHit candidate;
        tree.trace({&beside, 1}, {&plane, 1}, {&candidate, 1});
        const bool disagrees = candidate.met() && candidate.triangle != first.triangle;
        if (disagrees)
            if (const auto exact = exact_hit(scene, candidate.triangle, clear.origin, clear.direction);
                exact && counts(ray, *exact))
                return *exact;
        // The ray beside may have met the next wall instead, or, where both run within a hundredth along the plane
        // left, passed over the one that counts. Then all triangles are asked, unless that would take long: of rays
        // that really leave a scene, one in some hundred disagrees, one in ten thousand grazes.
        if (!grazes && !(disagrees && scene.triangles.size() <= few_triangles)) return {};
        return nearest_exact(scene, clear.origin, clear.direction, [&](const TriangleHit& hit) {
            return plane_of(hit.triangle) != plane && counts(ray, hit);
        });
    }

    bool counts(const Ray& ray, const TriangleHit& hit) const {
        return ray.meets_holes || !is_hole(scene, hit.triangle, hit.b1, hit.b2);
    }

    Hit hit_on(const Ray& ray, const TriangleHit& raw) const {
        if (!raw.met()) return {};
        const Triangle& triangle = scene.triangles[raw.triangle];
        const Chart& front = scene.charts[triangle.front_chart];
        Hit hit;
        hit.triangle = raw.triangle;
        hit.distance = raw.distance;
        hit.position = scene.point_inside(triangle, raw.b1, raw.b2);
        hit.b1 = raw.b1;
        hit.b2 = raw.b2;
        const bool from_front = glm::dot(front.normal, ray.direction) < 0.0f;
        hit.chart = from_front ? triangle.front_chart : triangle.back_chart;
        hit.normal = hit.shading_normal = from_front ? front.normal : -front.normal;
        hit.hole = ray.meets_holes && is_hole(scene, raw.triangle, raw.b1, raw.b2);
        if (hit.chart == no_chart) return hit;
        const glm::vec2 uv = scene.charts[hit.chart].unit_coordinates(hit.position);
        hit.u = chart_fixed_point(uv.x);
        hit.v = chart_fixed_point(uv.y);
        return hit;
    }

    const Scene& scene;
    const std::vector<Stand> stands;  // by surface
    const RayTree tree;
};

Rays::Rays(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Rays::~Rays() = default;

void Rays::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
    BREWSTER_CHECK(rays.size() == hits.size(),
                   std::to_string(rays.size()) + " rays, " + std::to_string(hits.size()) + " hits");
    constexpr std::size_t at_once = 64;
    TriangleHit raw[at_once];
    std::uint32_t planes[at_once];
    for (std::size_t first = 0; first < rays.size(); first += at_once) {
        const std::size_t count = std::min(at_once, rays.size() - first);
        for (std::size_t i = 0; i < count; ++i) planes[i] = impl_->plane_left(rays[first + i]);
        impl_->tree.trace(rays.subspan(first, count), {planes, count}, {raw, count});
        for (std::size_t i = 0; i < count; ++i) hits[first + i] = impl_->finished(rays[first + i], planes[i], raw[i]);
    }
}

}  // namespace brewster
