#include "scene/ray_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/albedo.h"

namespace brewster {
namespace {

static_assert(RTC_INVALID_GEOMETRY_ID == no_chart);

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseTree {
    void operator()(RTCScene tree) const { rtcReleaseScene(tree); }
};

// A context whose filter rejects hits on the plane that a ray leaves, which the ray carries as its id. Most rays that
// leave a plane meet it within rounding of their start: rejecting those on the way costs less than tracing them again.
// Rays pass through holes the same way, unless their flags say that they meet them.
struct PastContext {
    PastContext(const std::vector<std::uint32_t>& planes_of_triangles, const Scene* cut_out)
        : planes(&planes_of_triangles), scene(cut_out) {
        rtcInitIntersectContext(&base);
        base.filter = reject_plane;
    }

    static void reject_plane(const RTCFilterFunctionNArguments* arguments) {
        const auto& context = *reinterpret_cast<const PastContext*>(arguments->context);
        for (unsigned i = 0; i < arguments->N; ++i) {
            const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, i);
            const unsigned plane = RTCRayN_id(arguments->ray, arguments->N, i);
            if (!arguments->valid[i]) continue;
            if ((*context.planes)[triangle] == plane ||
                (context.scene && RTCRayN_flags(arguments->ray, arguments->N, i) == 0 &&
                 is_hole(*context.scene, triangle, RTCHitN_u(arguments->hit, arguments->N, i),
                         RTCHitN_v(arguments->hit, arguments->N, i))))
                arguments->valid[i] = 0;
        }
    }

    RTCIntersectContext base;
    const std::vector<std::uint32_t>* planes;
    const Scene* scene;  // null: nothing in it is cut out
};

TriangleHit trace_one(RTCScene tree, PastContext& context, const Ray& ray, std::uint32_t plane) {
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tfar = INFINITY;
    query.ray.mask = 0xffffffffu;
    query.ray.id = plane;
    query.ray.flags = ray.meets_holes;
    query.hit.geomID = query.hit.primID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(tree, &context.base, &query);
    return {query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
}

// Up to eight rays; lanes without one are switched off.
void trace_eight(RTCScene tree, PastContext& context, std::span<const Ray> rays, std::span<const std::uint32_t> planes,
                 TriangleHit* hits) {
    alignas(32) int valid[8];
    RTCRayHit8 query;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t index = std::min(i, rays.size() - 1);
        const Ray& ray = rays[index];
        valid[i] = i < rays.size() ? -1 : 0;
        query.ray.org_x[i] = ray.origin.x;
        query.ray.org_y[i] = ray.origin.y;
        query.ray.org_z[i] = ray.origin.z;
        query.ray.dir_x[i] = ray.direction.x;
        query.ray.dir_y[i] = ray.direction.y;
        query.ray.dir_z[i] = ray.direction.z;
        query.ray.tnear[i] = query.ray.time[i] = 0.0f;
        query.ray.tfar[i] = INFINITY;
        query.ray.mask[i] = 0xffffffffu;
        query.ray.id[i] = planes[index];
        query.ray.flags[i] = ray.meets_holes;
        query.hit.primID[i] = query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, tree, &context.base, &query);
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = {query.hit.primID[i], query.ray.tfar[i], query.hit.u[i], query.hit.v[i]};
}

}  // namespace

struct RayTree::Impl {
    std::vector<std::uint32_t> planes;
    const Scene* cut_out = nullptr;                      // the scene, if anything in it is cut out
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device;  // outlives the tree
    std::unique_ptr<RTCSceneTy, ReleaseTree> tree;
};

RayTree::RayTree(const Scene& scene, std::vector<std::uint32_t> planes) : impl_(std::make_unique<Impl>()) {
    impl_->planes = std::move(planes);
    if (std::any_of(scene.materials.begin(), scene.materials.end(),
                    [](const Material& material) { return material.alpha_cutoff > 0; }))
        impl_->cut_out = &scene;
    impl_->device.reset(rtcNewDevice("isa=avx2,threads=1,verbose=0"));
    const RTCDevice device = impl_->device.get();
    if (!device) throw Error("Embree does not start", scene.name, "use a CPU with AVX2");
    impl_->tree.reset(rtcNewScene(device));
    const RTCScene tree = impl_->tree.get();
    rtcSetSceneFlags(tree, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcSetSceneBuildQuality(tree, RTC_BUILD_QUALITY_HIGH);

    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    using Corners = decltype(Triangle::vertices);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), scene.vertices.size()));
    auto* corners = static_cast<Corners*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                  sizeof(Corners), scene.triangles.size()));
    if (vertices && corners) {
        std::copy(scene.vertices.begin(), scene.vertices.end(), vertices);
        for (const Triangle& triangle : scene.triangles) *corners++ = triangle.vertices;
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(tree, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tree);
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
        throw Error("its ray tree fails with Embree's error " + std::to_string(error), scene.name,
                    "simplify its meshes or free some memory");
}

RayTree::~RayTree() = default;

void RayTree::trace(std::span<const Ray> rays, std::span<const std::uint32_t> planes,
                    std::span<TriangleHit> hits) const {
    PastContext context(impl_->planes, impl_->cut_out);
    if (rays.size() == 1) {
        hits[0] = trace_one(impl_->tree.get(), context, rays[0], planes[0]);
        return;
    }
    for (std::size_t first = 0; first < rays.size(); first += 8) {
        const std::size_t count = std::min<std::size_t>(8, rays.size() - first);
        trace_eight(impl_->tree.get(), context, rays.subspan(first, count), planes.subspan(first, count), &hits[first]);
    }
}

}  // namespace brewster
