#include <embree3/rtcore.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "scene/vectors.h"
#include "transport/emitted_light.h"
#include "transport/interaction.h"

/// Photons in blocks against the scalar engine and against bare Embree, on one thread, in CPU seconds of the process:
/// `bench_photons ROUNDS PHOTONS SCENE...`. The rays of real photons are recorded and asked again, one by one, of an
/// Embree scene of the same triangles (robust, without filters, starting a little off their surface). Medians over the
/// rounds, in which all take turns.
namespace brewster {
namespace {

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds_of(const Work& work) {
    const double begin = cpu_seconds();
    work();
    return cpu_seconds() - begin;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Recorded {
    std::vector<Ray> rays;
    std::uint64_t photons = 0;
};

// The rays of the first photons, as the scalar engine would ask for them; holes end a path here.
Recorded recorded_rays(const TransportContext& context, std::size_t count) {
    using namespace transport;
    Recorded recorded;
    Books<float> books;
    TransportCounts counts;
    for (; recorded.rays.size() < count; ++recorded.photons) {
        const EmittedPhoton<float> emitted = context.emission.sample(recorded.photons);
        Ray ray = first_ray(emitted);
        Flight<float, 4, 3> flight;
        flight.direction = float_vector(ray.direction);
        flight.light = emitted_light<4, 3>(context.scene, context.emission, emitted);
        flight.reference = flight.light.largest();
        flight.key = {static_cast<std::uint32_t>(recorded.photons), 0, 0};
        flight.alive = flight.direct = true;
        for (; flight.alive; ++flight.key.bounce) {
            ray.meets_holes = true;
            recorded.rays.push_back(ray);
            Hit hit;
            context.rays.intersect({&ray, 1}, {&hit, 1});
            if (hit.chart == no_chart || hit.hole) break;
            Meeting<float> at;
            at.material = &context.materials[context.scene.charts[hit.chart].material];
            at.inside = is_inside(context, hit.triangle, hit.chart);
            at.normal = float_vector(hit.normal);
            at.shading_normal = float_vector(hit.shading_normal);
            at.filter_axis = filter_axis_of(context, hit.chart);
            cut_turned_away(at, flight, books);
            if (flight.alive) go_on(context, at, event_at(context, at, flight), flight, books, counts);
            ray = {hit.position, glm_vector(flight.direction), hit.triangle};
        }
    }
    return recorded;
}

class BareEmbree {
  public:
    explicit BareEmbree(const Scene& scene) : start_(1e-5f * scene.radius()) {
        device_ = rtcNewDevice("isa=avx2,threads=1");
        tree_ = rtcNewScene(device_);
        rtcSetSceneFlags(tree_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(tree_, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), scene.vertices.size()));
        std::copy(scene.vertices.begin(), scene.vertices.end(), vertices);
        auto* corners = static_cast<std::array<std::uint32_t, 3>*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(std::array<std::uint32_t, 3>), scene.triangles.size()));
        for (const Triangle& triangle : scene.triangles) *corners++ = triangle.vertices;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(tree_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(tree_);
    }
    ~BareEmbree() {
        rtcReleaseScene(tree_);
        rtcReleaseDevice(device_);
    }
    BareEmbree(const BareEmbree&) = delete;
    BareEmbree& operator=(const BareEmbree&) = delete;

    std::size_t hits(const std::vector<Ray>& rays) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t met = 0;
        for (const Ray& ray : rays) {
            RTCRayHit query{};
            query.ray = {ray.origin.x,
                         ray.origin.y,
                         ray.origin.z,
                         start_,
                         ray.direction.x,
                         ray.direction.y,
                         ray.direction.z,
                         0,
                         INFINITY,
                         ~0u,
                         0,
                         0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(tree_, &context, &query);
            met += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        return met;
    }

  private:
    float start_;
    RTCDevice device_;
    RTCScene tree_;
};

struct Run {
    double seconds = 0;
    Progress progress;
    double nanoseconds() const { return 1e9 * seconds / static_cast<double>(progress.rays); }
};

Run run(const std::shared_ptr<const Scene>& scene, std::uint64_t photons, std::size_t window, bool files_gloss = true) {
    EngineSettings settings;
    settings.threads = 1;
    settings.window = window;
    if (!files_gloss) {
        const Needs needs = needs_of(*scene);
        settings.kernel = KernelChoice{needs.stokes, needs.bands, false};
    }
    Engine engine(scene, settings);
    Run result;
    result.seconds = seconds_of([&] {
        StopRule rule;
        rule.photons = photons;
        engine.start(rule);
        engine.wait();
    });
    result.progress = engine.progress();
    return result;
}

void measure(const std::string& path, std::size_t rounds, std::uint64_t photons) {
    const auto scene = std::make_shared<const Scene>(read_scene(path));
    const std::vector<PreparedMaterial> materials = prepare_materials(scene->materials);
    const Rays rays(*scene);
    const PhotonEmission emission(*scene, 1);
    const Bins bins({}, {}, {}, {}, {});
    const TransportContext context{*scene, rays, emission, materials, bins, 1, false};
    const Recorded recorded = recorded_rays(context, 200000);
    const BareEmbree embree(*scene);
    std::vector<TriangleHit> hits(default_window);

    std::vector<double> bare, asked, emitted, filing, block, scalar, over_bare, over_scalar;
    std::size_t met = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
        const auto count = static_cast<double>(recorded.rays.size());
        bare.push_back(1e9 / count * seconds_of([&] { met += embree.hits(recorded.rays); }));
        asked.push_back(1e9 / count * seconds_of([&] {
                            for (std::size_t first = 0; first < recorded.rays.size(); first += hits.size()) {
                                const std::size_t size = std::min(hits.size(), recorded.rays.size() - first);
                                rays.meet({&recorded.rays[first], size}, {hits.data(), size});
                            }
                        }));
        emitted.push_back(1e9 / count * seconds_of([&] {
                              for (std::uint64_t photon = 0; photon < recorded.photons; photon += lane_count)
                                  met += any_of(emission.sample_lanes(photon).start.position.x > 1e30f);
                          }));
        block.push_back(run(scene, photons, default_window).nanoseconds());
        filing.push_back(block.back() - run(scene, photons, default_window, false).nanoseconds());
        scalar.push_back(run(scene, photons / 4, 0).nanoseconds());
        over_bare.push_back(bare.back() / block.back());
        over_scalar.push_back(scalar.back() / block.back());
    }
    std::printf("%-16s %6.2f %9.1f %9.1f %8.1f %9.1f %9.1f %9.1f %9.2f %9.2f%s\n", scene->name.c_str(),
                static_cast<double>(recorded.rays.size()) / static_cast<double>(recorded.photons), median(bare),
                median(scalar), median(block), median(asked), median(emitted), median(filing), median(over_bare),
                median(over_scalar), met == 0 ? " (no hits)" : "");
}

}  // namespace
}  // namespace brewster

int main(int count, char** arguments) {
    if (count < 4) {
        std::fprintf(stderr, "usage: bench_photons ROUNDS PHOTONS SCENE...\n");
        return 2;
    }
    std::printf(
        "nanoseconds a ray: rays/photon, bare Embree, scalar, blocks, of these asking for hits, emission and filing "
        "gloss; "
        "bare/blocks, scalar/blocks\n");
    for (int i = 3; i < count; ++i)
        brewster::measure(arguments[i], std::stoul(arguments[1]), static_cast<std::uint64_t>(std::stod(arguments[2])));
}
