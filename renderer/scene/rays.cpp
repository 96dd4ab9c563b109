#include "scene/rays.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "base/error.h"
#include "scene/exact_hit.h"
#include "scene/planes.h"
#include "scene/seams.h"
#include "scene/surfaces.h"

namespace brewster {
namespace {

// What Embree knows of a hit.
struct RawHit {
    unsigned primitive = RTC_INVALID_GEOMETRY_ID;
    float distance = 0, b1 = 0, b2 = 0;

    bool met() const { return primitive != RTC_INVALID_GEOMETRY_ID; }
};

// A context whose filter rejects hits on the plane of one surface.
struct LeavingContext {
    RTCIntersectContext base;
    const Scene* scene;
    const std::vector<std::uint32_t>* planes;  // by surface
    const std::vector<Seam>* seams;            // null: primitives are triangles
    std::uint32_t leaving;

    bool rejects(unsigned primitive) const {
        const std::uint32_t surface = scene->triangles[seams ? (*seams)[primitive / 2].triangle : primitive].surface;
        return leaving != no_surface && (*planes)[surface] == (*planes)[leaving];
    }
};

void reject_leaving(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const LeavingContext*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i)
        if (arguments->valid[i] && context.rejects(RTCHitN_primID(arguments->hit, arguments->N, i)))
            arguments->valid[i] = 0;
}

RTCRayHit embree_ray(const Ray& ray) {
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tfar = INFINITY;
    query.ray.mask = 0xffffffffu;
    query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
    return query;
}

RawHit raw_hit(const RTCRayHit& query) {
    return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
}

// The planes that surfaces lie in, either way up: a ray that leaves one surface of a plane cannot meet another.
std::vector<std::uint32_t> planes_of_surfaces(const Scene& scene) {
    constexpr double same_plane = 1e-6;  // of the size
    std::vector<glm::vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> halves;
    std::vector<std::uint32_t> surfaces;  // of the rectangles
    for (std::uint32_t i = 0; i < scene.charts.size(); ++i) {
        const Chart& chart = scene.charts[i];
        if (scene.triangles[chart.first_triangle].front_chart != i) continue;
        const glm::vec3 u = chart.size_u * chart.axis_u, v = chart.size_v * chart.axis_v, n = chart.normal;
        const bool turned = n.x < 0 || (n.x == 0 && (n.y < 0 || (n.y == 0 && n.z < 0)));
        const auto first = static_cast<std::uint32_t>(corners.size());
        for (const glm::vec3& corner : {chart.origin, chart.origin + u, chart.origin + u + v, chart.origin + v})
            corners.push_back(corner);
        for (const std::uint32_t k : {1u, 2u})
            halves.push_back({first, first + (turned ? k + 1 : k), first + (turned ? k : k + 1)});
        surfaces.push_back(chart.surface);
    }
    std::vector<std::uint32_t> planes(surfaces.empty() ? 0 : surfaces.back() + 1);
    std::uint32_t plane = 0;
    for (const PlaneGroup& group : plane_groups(corners, halves, same_plane)) {
        for (const std::uint32_t half : group.triangles) planes[surfaces[half / 2]] = plane;
        ++plane;
    }
    return planes;
}

// What a second try needs to know of the surface a ray leaves.
struct Stand {
    glm::vec3 normal{0.0f}, middle{0.0f};
    float size = 0, inset = 0;
};

std::vector<Stand> stands_of_surfaces(const Scene& scene) {
    std::vector<Stand> stands;
    for (const Chart& chart : scene.charts) {
        if (chart.surface != stands.size()) continue;
        const glm::vec3 diagonal = chart.size_u * chart.axis_u + chart.size_v * chart.axis_v;
        stands.push_back(
            {chart.normal, chart.origin + 0.5f * diagonal, chart.size(), static_cast<float>(hit_inset(chart))});
    }
    return stands;
}

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using Tree = std::unique_ptr<RTCSceneTy, ReleaseScene>;

}  // namespace

struct Rays::Impl {
    explicit Impl(const Scene& whole)
        : scene(whole), seams(open_seams(whole)), planes(planes_of_surfaces(whole)), stands(stands_of_surfaces(whole)) {
        // Another instruction set gives other bits; robust: shared edges are watertight.
        device.reset(rtcNewDevice("isa=avx2,threads=1,verbose=0"));
        if (!device) throw Error("Embree does not start", "rays", "use a CPU with AVX2");
        std::vector<std::array<std::uint32_t, 3>> indices;
        for (const Triangle& triangle : scene.triangles) indices.push_back(triangle.vertices);
        surfaces = commit(scene.vertices, indices);

        std::vector<glm::vec3> corners;
        indices.clear();
        for (const Seam& seam : seams) {
            const auto first = static_cast<std::uint32_t>(corners.size());
            corners.insert(corners.end(), seam.corners.begin(), seam.corners.end());
            indices.push_back({first, first + 1, first + 2});
            indices.push_back({first, first + 2, first + 3});
        }
        if (!seams.empty()) edges = commit(corners, indices);
    }

    Tree commit(const std::vector<glm::vec3>& vertices,
                const std::vector<std::array<std::uint32_t, 3>>& indices) const {
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertex_buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                      sizeof(glm::vec3), vertices.size());
        void* index_buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                     sizeof indices[0], indices.size());
        if (!vertex_buffer || !index_buffer) {
            rtcReleaseGeometry(geometry);
            throw Error("there is no memory for its ray tree", scene.name, "simplify its meshes");
        }
        std::copy(vertices.begin(), vertices.end(), static_cast<glm::vec3*>(vertex_buffer));
        std::copy(indices.begin(), indices.end(), static_cast<std::array<std::uint32_t, 3>*>(index_buffer));
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        Tree tree(rtcNewScene(device.get()));
        rtcSetSceneFlags(tree.get(),
                         static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
        rtcSetSceneBuildQuality(tree.get(), RTC_BUILD_QUALITY_HIGH);
        rtcAttachGeometry(tree.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(tree.get());
        if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE)
            throw Error("Embree fails with code " + std::to_string(error), scene.name, "simplify its meshes");
        return tree;
    }

    static RawHit trace(RTCScene tree, const Ray& ray) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query = embree_ray(ray);
        rtcIntersect1(tree, &context, &query);
        return raw_hit(query);
    }

    RawHit trace_leaving(RTCScene tree, const std::vector<Seam>* of_seams, const Ray& ray) const {
        LeavingContext context{{}, &scene, &planes, of_seams, ray.leaving};
        rtcInitIntersectContext(&context.base);
        context.base.filter = reject_leaving;
        RTCRayHit query = embree_ray(ray);
        rtcIntersect1(tree, &context.base, &query);
        return raw_hit(query);
    }

    void trace_eight(const Ray* rays, std::size_t count, RawHit* hits) const {
        alignas(32) int valid[8];
        RTCRayHit8 query;
        for (std::size_t i = 0; i < 8; ++i) {
            const Ray& ray = rays[std::min(i, count - 1)];
            valid[i] = i < count ? -1 : 0;
            query.ray.org_x[i] = ray.origin.x;
            query.ray.org_y[i] = ray.origin.y;
            query.ray.org_z[i] = ray.origin.z;
            query.ray.dir_x[i] = ray.direction.x;
            query.ray.dir_y[i] = ray.direction.y;
            query.ray.dir_z[i] = ray.direction.z;
            query.ray.tnear[i] = query.ray.time[i] = 0.0f;
            query.ray.tfar[i] = INFINITY;
            query.ray.mask[i] = 0xffffffffu;
            query.ray.id[i] = query.ray.flags[i] = 0;
            query.hit.primID[i] = query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect8(valid, surfaces.get(), &context, &query);
        for (std::size_t i = 0; i < count; ++i)
            hits[i] = {query.hit.primID[i], query.ray.tfar[i], query.hit.u[i], query.hit.v[i]};
    }

    // From the first answer to the hit: past the plane left, and where that meets nothing or a back, by closer looks.
    Hit finished(const Ray& ray, RawHit raw) const {
        if (raw.met() && ray.leaving != no_surface && in_plane_left(raw.primitive, ray))
            raw = trace_leaving(surfaces.get(), nullptr, ray);
        const Hit hit = raw.met() ? hit_on(ray, raw.primitive, raw) : Hit{};
        if (hit.chart != no_chart) return hit;
        if (ray.leaving != no_surface) {
            const Hit closer = closer_look(ray, raw);
            if (closer.chart != no_chart) return closer;
        }
        if (!edges || !hit.escaped()) return hit;
        const Ray clear = ray.leaving != no_surface ? raised(ray, stands[ray.leaving].inset) : ray;
        raw = trace_leaving(edges.get(), &seams, clear);
        return raw.met() ? hit_on(ray, seams[raw.primitive / 2].triangle, onto_triangle(raw)) : hit;
    }

    bool in_plane_left(std::uint32_t triangle, const Ray& ray) const {
        return planes[scene.triangles[triangle].surface] == planes[ray.leaving];
    }

    // Single precision cannot decide for a ray that starts within rounding of its plane close to a wall's foot, or runs
    // along an edge. A ray beside it, clear of all edges, shows which triangle it ought to meet; double precision then
    // says whether it does.
    Hit closer_look(const Ray& ray, const RawHit& first) const {
        constexpr float aside = 1e-3f, above = 1e-4f, grazing = 0.01f;
        const Stand& stand = stands[ray.leaving];
        Ray beside = raised(ray, above * stand.size);
        beside.origin += aside * (stand.middle - ray.origin);
        const RawHit candidate = trace_leaving(surfaces.get(), nullptr, beside);
        const bool grazes = std::abs(glm::dot(stand.normal, ray.direction)) < grazing;
        if (candidate.primitive == first.primitive && !grazes) return {};  // nothing, or the same back: so it is
        const Ray clear = raised(ray, stand.inset);
        auto exact =
            candidate.met() ? exact_hit(scene, candidate.primitive, clear.origin, clear.direction) : std::nullopt;
        if (!exact)
            exact = nearest_exact(scene, clear.origin, clear.direction,
                                  [&](std::uint32_t triangle) { return !in_plane_left(triangle, ray); });
        if (!exact) return {};
        return hit_on(ray, exact->triangle, {exact->triangle, exact->distance, exact->b1, exact->b2});
    }

    // The ray from a start that lies this far on its side of the plane.
    Ray raised(Ray ray, float height) const {
        const glm::vec3& normal = stands[ray.leaving].normal;
        ray.origin += glm::dot(normal, ray.direction) < 0.0f ? -height * normal : height * normal;
        return ray;
    }

    // Barycentric coordinates on the seam's triangle of a point beside its edge; `point_inside` pulls them in.
    RawHit onto_triangle(RawHit raw) const {
        const Seam& seam = seams[raw.primitive / 2];
        const bool second = raw.primitive % 2 != 0;
        const glm::dvec3 s0(seam.corners[0]), s1(seam.corners[second ? 2 : 1]), s2(seam.corners[second ? 3 : 2]);
        const glm::dvec3 p = s0 + static_cast<double>(raw.b1) * (s1 - s0) + static_cast<double>(raw.b2) * (s2 - s0);
        const Triangle& triangle = scene.triangles[seam.triangle];
        const glm::dvec3 a(scene.vertices[triangle.vertices[0]]);
        const glm::dvec3 e1 = glm::dvec3(scene.vertices[triangle.vertices[1]]) - a;
        const glm::dvec3 e2 = glm::dvec3(scene.vertices[triangle.vertices[2]]) - a;
        const glm::dvec3 n = glm::cross(e1, e2);
        raw.b1 = static_cast<float>(glm::dot(glm::cross(p - a, e2), n) / glm::dot(n, n));
        raw.b2 = static_cast<float>(glm::dot(glm::cross(e1, p - a), n) / glm::dot(n, n));
        return raw;
    }

    Hit hit_on(const Ray& ray, std::uint32_t index, const RawHit& raw) const {
        const Triangle& triangle = scene.triangles[index];
        const Chart& front = scene.charts[triangle.front_chart];
        Hit hit;
        hit.triangle = index;
        hit.distance = raw.distance;
        hit.position = scene.point_inside(triangle, raw.b1, raw.b2);
        hit.chart = glm::dot(front.normal, ray.direction) < 0.0f ? triangle.front_chart : triangle.back_chart;
        if (hit.chart == no_chart) return hit;
        const glm::vec2 uv = scene.charts[hit.chart].unit_coordinates(hit.position);
        hit.u = chart_fixed_point(uv.x);
        hit.v = chart_fixed_point(uv.y);
        return hit;
    }

    const Scene& scene;
    const std::vector<Seam> seams;
    const std::vector<std::uint32_t> planes;  // by surface
    const std::vector<Stand> stands;          // by surface
    Device device;                            // outlives the trees
    Tree surfaces, edges;
};

Rays::Rays(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Rays::~Rays() = default;

void Rays::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
    BREWSTER_CHECK(rays.size() == hits.size(),
                   std::to_string(rays.size()) + " rays, " + std::to_string(hits.size()) + " hits");
    if (rays.size() == 1) {
        hits[0] = impl_->finished(rays[0], Impl::trace(impl_->surfaces.get(), rays[0]));
        return;
    }
    for (std::size_t first = 0; first < rays.size(); first += 8) {
        const std::size_t count = std::min<std::size_t>(8, rays.size() - first);
        RawHit raw[8];
        impl_->trace_eight(&rays[first], count, raw);
        for (std::size_t i = 0; i < count; ++i) hits[first + i] = impl_->finished(rays[first + i], raw[i]);
    }
}

}  // namespace brewster
