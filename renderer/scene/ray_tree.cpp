#include "scene/ray_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "scene/albedo.h"
#include "scene/mesh_boxes.h"

namespace brewster {
namespace {

static_assert(RTC_INVALID_GEOMETRY_ID == no_chart);

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseTree {
    void operator()(RTCScene tree) const { rtcReleaseScene(tree); }
};

// A context whose filter rejects hits that a ray passes by; it carries the triangle it leaves as its id. Most rays that
// leave a plane meet it within rounding of their start: rejecting those on the way costs less than tracing them again.
// Rays pass through holes the same way, unless their flags say that they meet them.
struct PastContext {
    PastContext(const PassedBy& rule, const Scene* cut_out, const std::uint32_t* triangles)
        : passed_by(&rule), scene(cut_out), triangle_of(triangles) {
        rtcInitIntersectContext(&base);
        base.filter = reject;
    }

    static void reject(const RTCFilterFunctionNArguments* arguments) {
        const auto& context = *reinterpret_cast<const PastContext*>(arguments->context);
        const unsigned count = arguments->N;
        for (unsigned i = 0; i < count; ++i) {
            if (!arguments->valid[i]) continue;
            const std::uint32_t triangle = context.triangle_of[RTCHitN_primID(arguments->hit, count, i)];
            const glm::vec3 direction(RTCRayN_dir_x(arguments->ray, count, i), RTCRayN_dir_y(arguments->ray, count, i),
                                      RTCRayN_dir_z(arguments->ray, count, i));
            if ((*context.passed_by)(triangle, RTCRayN_id(arguments->ray, count, i), direction) ||
                (context.scene && RTCRayN_flags(arguments->ray, count, i) == 0 &&
                 is_hole(*context.scene, triangle, RTCHitN_u(arguments->hit, count, i),
                         RTCHitN_v(arguments->hit, count, i))))
                arguments->valid[i] = 0;
        }
    }

    RTCIntersectContext base;
    const PassedBy* passed_by;
    const Scene* scene;  // null: nothing in it is cut out
    const std::uint32_t* triangle_of;
};

// Up to eight rays, chosen by their places; lanes without one are switched off. A single ray in a packet gets the bits
// that it would get alone.
void improve_eight(RTCScene tree, PastContext& context, std::span<const Ray> rays, std::span<TriangleHit> hits,
                   std::span<const std::uint32_t> places) {
    alignas(32) int valid[8];
    RTCRayHit8 query;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t place = places[std::min(i, places.size() - 1)];
        const Ray& ray = rays[place];
        valid[i] = i < places.size() ? -1 : 0;
        query.ray.org_x[i] = ray.origin.x;
        query.ray.org_y[i] = ray.origin.y;
        query.ray.org_z[i] = ray.origin.z;
        query.ray.dir_x[i] = ray.direction.x;
        query.ray.dir_y[i] = ray.direction.y;
        query.ray.dir_z[i] = ray.direction.z;
        query.ray.tnear[i] = query.ray.time[i] = 0.0f;
        query.ray.tfar[i] = hits[place].distance;
        query.ray.mask[i] = 0xffffffffu;
        query.ray.id[i] = ray.leaving;
        query.ray.flags[i] = ray.meets_holes;
        query.hit.primID[i] = query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, tree, &context.base, &query);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
            hits[places[i]] = {context.triangle_of[query.hit.primID[i]], query.ray.tfar[i], query.hit.u[i],
                               query.hit.v[i]};
}

}  // namespace

struct RayTree::Impl {
    const PassedBy& passed_by;
    const std::vector<std::uint32_t> triangles;
    const MeshBoxes boxes;
    const Scene* cut_out = nullptr;                      // the scene, if anything in it is cut out
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device;  // outlives the tree
    std::unique_ptr<RTCSceneTy, ReleaseTree> tree;
};

RayTree::RayTree(const Scene& scene, const PassedBy& passed_by, const std::vector<std::uint32_t>& triangles)
    : impl_(std::make_unique<Impl>(Impl{passed_by, triangles, MeshBoxes(scene, triangles), nullptr, {}, {}})) {
    if (triangles.empty()) return;
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
                                                                  sizeof(Corners), impl_->triangles.size()));
    if (vertices && corners) {
        std::copy(scene.vertices.begin(), scene.vertices.end(), vertices);
        for (const std::uint32_t triangle : impl_->triangles) *corners++ = scene.triangles[triangle].vertices;
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

void RayTree::improve(std::span<const Ray> rays, std::span<TriangleHit> hits) const {
    if (impl_->triangles.empty()) return;
    PastContext context(impl_->passed_by, impl_->cut_out, impl_->triangles.data());
    constexpr std::size_t at_once = 256;
    std::array<std::uint32_t, at_once> places;
    for (std::size_t first = 0; first < rays.size(); first += at_once) {
        const std::size_t count = std::min(at_once, rays.size() - first);
        const std::span<const std::uint32_t> crossing =
            impl_->boxes.crossed_by(rays.subspan(first, count), hits.subspan(first, count), places);
        for (std::size_t i = 0; i < crossing.size(); i += 8)
            improve_eight(impl_->tree.get(), context, rays.subspan(first, count), hits.subspan(first, count),
                          crossing.subspan(i, std::min<std::size_t>(8, crossing.size() - i)));
    }
}

}  // namespace brewster
