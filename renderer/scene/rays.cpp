#include "scene/rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "scene/albedo.h"
#include "scene/exact_hit.h"
#include "scene/landing.h"
#include "scene/passed_by.h"
#include "scene/ray_tree.h"
#include "scene/surfaces.h"
#include "scene/vectors.h"
#include "scene/walls.h"

namespace brewster {
namespace {

// What a second try needs to know of the surface a ray leaves.
struct Stand {
    glm::vec3 normal{0.0f}, middle{0.0f};
    float size = 0, inset = 0;

    glm::vec3 up(const Ray& ray) const { return glm::dot(normal, ray.direction) < 0.0f ? -normal : normal; }
};

Stand stand_on(const Scene& scene, const Triangle& triangle) {
    const Chart& chart = scene.charts[triangle.front_chart];
    const auto inset = static_cast<float>(hit_inset(chart));
    if (!chart.curved) {
        const glm::vec3 diagonal = chart.size_u * chart.axis_u + chart.size_v * chart.axis_v;
        return {chart.normal, chart.origin + 0.5f * diagonal, chart.size(), inset};
    }
    glm::vec3 sum(0.0f);
    for (const std::uint32_t vertex : triangle.vertices) sum += scene.vertices[vertex];
    return {scene.facet_normal(triangle), sum / 3.0f, chart.size(), inset};
}

TriangleShape<float> shape_of(const LandingTriangle& triangle) {
    return {float_vector(triangle.corner), float_vector(triangle.edge1), float_vector(triangle.edge2),
            float_vector(triangle.margin)};
}

ChartShape<float> shape_of(const LandingChart& chart) {
    return {float_vector(chart.origin), float_vector(chart.axis_u), float_vector(chart.axis_v), chart.size_u,
            chart.size_v};
}

}  // namespace

struct Rays::Impl {
    explicit Impl(const Scene& whole)
        : scene(whole),
          table(whole),
          passed_by(whole),
          walls(whole, passed_by.planes()),
          tree(whole, passed_by, walls.others()) {}

    // The nearest triangles.
    void trace(std::span<const Ray> rays, std::span<TriangleHit> hits) const {
        constexpr std::size_t at_once = 256;
        std::array<std::uint32_t, at_once> planes;
        for (std::size_t first = 0; first < rays.size(); first += at_once) {
            const std::size_t count = std::min(at_once, rays.size() - first);
            for (std::size_t i = 0; i < count; ++i) planes[i] = passed_by.plane_left(rays[first + i].leaving);
            walls.trace(rays.subspan(first, count), planes.data(), &hits[first]);
            tree.improve(rays.subspan(first, count), hits.subspan(first, count));
        }
    }

    // Where the first answer is nothing or a back, a closer look decides. The rays that it asks beside are traced
    // together.
    void settle(std::span<const Ray> rays, std::span<TriangleHit> hits) const {
        constexpr std::size_t at_once = 64;
        std::array<std::uint32_t, at_once> doubtful;
        std::array<Ray, at_once> beside;
        std::array<TriangleHit, at_once> candidates;
        for (std::size_t next = 0; next < rays.size();) {
            std::size_t count = 0;
            for (; next < rays.size() && count < at_once; ++next) {
                const Ray& ray = rays[next];
                const TriangleHit& hit = hits[next];
                if (hit.met() && (chart_of(ray, hit) != no_chart || is_met_hole(ray, hit))) continue;
                doubtful[count] = static_cast<std::uint32_t>(next);
                beside[count++] = ray_beside(ray);
            }
            trace({beside.data(), count}, {candidates.data(), count});
            for (std::size_t i = 0; i < count; ++i) {
                const Ray& ray = rays[doubtful[i]];
                const TriangleHit closer = closer_look(ray, hits[doubtful[i]], candidates[i]);
                if (closer.met() && chart_of(ray, closer) != no_chart) hits[doubtful[i]] = closer;
            }
        }
    }

    std::uint32_t chart_of(const Ray& ray, const TriangleHit& hit) const {
        const LandingTriangle& triangle = table.triangles[hit.triangle];
        return triangle.chart(is_met_in_front(float_vector(triangle.normal), float_vector(ray.direction)));
    }

    bool is_met_hole(const Ray& ray, const TriangleHit& hit) const {
        return ray.meets_holes && table.triangles[hit.triangle].cut_out != 0 &&
               is_hole(scene, hit.triangle, hit.b1, hit.b2);
    }

    // Single precision cannot decide for a ray that starts within rounding of its plane close to a wall's foot, that
    // runs along an edge, or that meets the gap, a few units in the last place wide, between a wall and another that
    // ends within its edge. A ray beside it, clear of all edges, shows which triangle it ought to meet (`candidate`);
    // double precision then says whether it does, counting what lies as close beside the triangle as hits are pulled
    // inside.
    Ray ray_beside(const Ray& ray) const {
        Ray beside = ray;
        if (ray.leaving == no_triangle) {
            beside.origin += 1e-4f * scene.radius() * glm::vec3(ray.direction.y, ray.direction.z, ray.direction.x);
        } else {
            const Stand stand = stand_on(scene, scene.triangles[ray.leaving]);
            beside.origin += 1e-4f * stand.size * stand.up(ray) + 1e-3f * (stand.middle - ray.origin);
        }
        return beside;
    }

    TriangleHit closer_look(const Ray& ray, const TriangleHit& first, const TriangleHit& candidate) const {
        constexpr float grazing = 0.01f;
        constexpr std::size_t few_triangles = 4096;
        Ray clear = ray;
        bool grazes = false;
        if (ray.leaving != no_triangle) {
            const Stand stand = stand_on(scene, scene.triangles[ray.leaving]);
            grazes = std::abs(glm::dot(stand.normal, ray.direction)) < grazing;
            clear.origin += stand.inset * stand.up(ray);
        }
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
            return !passed_by(hit.triangle, ray.leaving, ray.direction) && counts(ray, hit);
        });
    }

    bool counts(const Ray& ray, const TriangleHit& hit) const {
        return ray.meets_holes || !is_hole(scene, hit.triangle, hit.b1, hit.b2);
    }

    Hit hit_on(const Ray& ray, const TriangleHit& raw) const {
        if (!raw.met()) return {};
        const LandingTriangle& triangle = table.triangles[raw.triangle];
        const Vector<float> normal = float_vector(triangle.normal);
        const Barycentric<float> at{raw.b1, raw.b2};
        Hit hit;
        hit.triangle = raw.triangle;
        hit.distance = raw.distance;
        const Vector<float> position = point_inside(shape_of(triangle), at);
        hit.position = glm_vector(position);
        hit.b1 = raw.b1;
        hit.b2 = raw.b2;
        const bool from_front = is_met_in_front(normal, float_vector(ray.direction));
        hit.chart = triangle.chart(from_front);
        hit.normal = glm_vector(from_front ? normal : -normal);
        hit.hole = is_met_hole(ray, raw);
        hit.shading_normal = hit.normal;
        if (hit.chart == no_chart) return hit;
        if (triangle.smooth) {
            const auto& corners = table.normals[raw.triangle].at;
            const Vector<float> shading = interpolated_normal(
                {float_vector(corners[0]), float_vector(corners[1]), float_vector(corners[2])}, normal, at);
            hit.shading_normal = glm_vector(from_front ? shading : -shading);
        }
        const UnitCoordinates<float> uv = unit_coordinates(shape_of(table.charts[hit.chart]), position);
        hit.u = fixed_coordinate(uv.u);
        hit.v = fixed_coordinate(uv.v);
        return hit;
    }

    const Scene& scene;
    const LandingTable table;
    const PassedBy passed_by;
    const Walls walls;
    const RayTree tree;  // of all that is no wall; refers to passed_by
};

Rays::Rays(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Rays::~Rays() = default;

void Rays::meet(std::span<const Ray> rays, std::span<TriangleHit> hits) const {
    impl_->trace(rays, hits);
    impl_->settle(rays, hits);
}

void Rays::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
    BREWSTER_CHECK(rays.size() == hits.size(),
                   std::to_string(rays.size()) + " rays, " + std::to_string(hits.size()) + " hits");
    constexpr std::size_t at_once = 64;
    TriangleHit raw[at_once];
    for (std::size_t first = 0; first < rays.size(); first += at_once) {
        const std::size_t count = std::min(at_once, rays.size() - first);
        meet(rays.subspan(first, count), {raw, count});
        for (std::size_t i = 0; i < count; ++i) hits[first + i] = impl_->hit_on(rays[first + i], raw[i]);
    }
}

const LandingTable& Rays::landing_table() const {
    return impl_->table;
}

}  // namespace brewster
