#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "base/philox.h"
#include "bins/direction_map.h"
#include "scene/albedo.h"
#include "scene/bsdf.h"
#include "scene/filter_axis.h"
#include "scene/shading_normal.h"
#include "transport/context.h"
#include "transport/deposit.h"
#include "transport/emitted_light.h"
#include "transport/kernel.h"
#include "transport/path.h"

/// Transport of one photon at a time, written to be read; compiled once for each kernel (kernels/). What ships moves
/// photons in blocks and gives the same bits: this is its oracle.
namespace brewster::transport {

inline constexpr std::uint32_t bounce_limit = 1u << 16;  // no room is this bright; what is left there is booked as cut
inline constexpr float roulette_share = 0.25f;           // of the weight at emission, below which the roulette begins

template <int components, int bands>
void book(Ledger::Account& account, const PhotonLight<components, bands>& light) {
    for (int world = 0; world < PhotonLight<components, bands>::worlds; ++world)
        for (int band = 0; band < bands; ++band)
            account[static_cast<std::size_t>(world)][static_cast<std::size_t>(band)] +=
                to_quanta(light.power(world, band));
}

/// What an event took, in the quanta of before less those of after, so that the accounts add up exactly.
template <int components, int bands>
void book(Ledger::Account& account, const PhotonLight<components, bands>& before,
          const PhotonLight<components, bands>& after) {
    for (int world = 0; world < PhotonLight<components, bands>::worlds; ++world)
        for (int band = 0; band < bands; ++band)
            account[static_cast<std::size_t>(world)][static_cast<std::size_t>(band)] +=
                to_quanta(before.power(world, band)) - to_quanta(after.power(world, band));
}

/// A surface as a photon meets it.
struct Meeting {
    Hit hit;
    const PreparedMaterial* material;
    Vector<float> normal, shading_normal;
    bool inside;  ///< of a closed transparent body
};

inline Meeting meeting_of(const TransportContext& context, const Hit& hit) {
    const Scene& scene = context.scene;
    const Chart& chart = scene.charts[hit.chart];
    const PreparedMaterial& material = context.materials[chart.material];
    const bool inside =
        material.base == Base::transparent && !material.thin && hit.chart == scene.triangles[hit.triangle].back_chart;
    return {hit, &material, float_vector(hit.normal), float_vector(hit.shading_normal), inside};
}

/// |i.N_s| / |i.N_g|, by which the flux that enters a smooth mesh exceeds the photon's (theory 4.1); not positive where
/// the shading normal turns away from the light.
inline float cosine_ratio(const Vector<float>& direction, const Meeting& at) {
    return dot(direction, at.shading_normal) / dot(direction, at.normal);
}

/// Numbers of one event. The first event of a photon goes on with its Sobol sequence.
inline ScatterNumbers<float> scatter_numbers(const TransportContext& context, std::uint64_t photon,
                                             std::uint32_t bounce, bool first, bool facets) {
    ScatterNumbers<float> numbers;
    const std::array<std::uint32_t, 4> words = philox(context.seed, photon, bounce, 0);
    numbers.exit_u = unit_float(words[1]);
    numbers.exit_v = unit_float(words[2]);
    numbers.choice = unit_float(words[3]);
    if (first) {
        numbers.exit_u = context.emission.sobol(photon, PhotonEmission::dimensions);
        numbers.exit_v = context.emission.sobol(photon, PhotonEmission::dimensions + 1);
        numbers.choice = context.emission.sobol(photon, PhotonEmission::dimensions + 2);
    }
    if (!facets) return numbers;
    const std::array<std::uint32_t, 4> more = philox(context.seed, photon, bounce, 1);
    numbers.slope = unit_float(more[0]);
    numbers.facet_u = unit_float(more[1]);
    numbers.facet_v = unit_float(more[2]);
    numbers.facet_w = unit_float(more[3]);
    return numbers;
}

/// One event: Mueller matrices for the polarized world, their m00 for the other.
template <int components, int bands>
void scatter_by(const ScatterSample<float, static_cast<std::size_t>(bands)>& sample,
                PhotonLight<components, bands>& light) {
    for (std::size_t b = 0; b < bands; ++b) {
        light.polarized[b] = made_realizable(sample.weight[b] * rotate(sample.turn, light.polarized[b]));
        if constexpr (PhotonLight<components, bands>::two_worlds) light.unpolarized[b] *= sample.weight[b].m00;
    }
    light.axis = sample.axis;
}

/// Files what enters the base: through the interface by its passage, per world. Under a shading normal the flux per area
/// of the surface that is meant differs from that of the facet by the ratio of the cosines.
template <int components, int bands>
void deposit_entry(const TransportContext& context, const Meeting& at, const Vector<float>& direction,
                   const PhotonLight<components, bands>& light, bool direct, std::uint32_t replica, Tally<2>& tally) {
    const float ratio = std::min(cosine_ratio(direction, at), static_cast<float>(largest_normal_correction));
    if (!(ratio > 0)) return;
    const PlaneOfIncidence<float> plane = plane_of_incidence(direction, light.axis, at.shading_normal);
    std::array<float, static_cast<std::size_t>(2 * bands)> entered;
    for (int band = 0; band < bands; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const Passage<float> passage = at.material->passage(b, plane.cos_theta_i);
        const Stokes<float, components> turned = rotate(plane.turn, light.polarized[b]);
        entered[b] = ratio * fma(passage.unpolarized, turned.s0(), passage.s_minus_p * turned.s1());
        entered[b + bands] = ratio * passage.unpolarized * light.power(1, band);
    }
    const int worlds = context.bins.entry_fields.worlds(direct ? 0 : 1);
    deposit(context.bins.entry, context.bins.entry_fields, tally, at.hit,
            std::span(entered.data(), static_cast<std::size_t>(worlds * bands)), direct, replica);
}

inline constexpr int gloss_deposits = 8;  // directions filed for each arrival; one more goes on

/// Files what the interface sends on, in several directions of its own lobe: each carries its share of the whole. The
/// direction stands relative to the shading normal, in the frame that comes from the chart's by the shortest turn, so
/// that a lobe stands still across a curved cell.
template <int components, int bands>
void deposit_gloss(const TransportContext& context, const Meeting& at, const Vector<float>& direction,
                   const PhotonLight<components, bands>& light, std::uint64_t photon, std::uint32_t bounce,
                   Tally<4>& tally) {
    const float ratio = std::min(cosine_ratio(direction, at), static_cast<float>(largest_normal_correction));
    if (!(ratio > 0)) return;
    const Chart& chart = context.scene.charts[at.hit.chart];
    const Vector<float> mean_normal = float_vector(chart.normal);
    const Vector<float> tangent_u = transported_axis(mean_normal, float_vector(chart.axis_u), at.shading_normal);
    const Vector<float> tangent_v = transported_axis(mean_normal, float_vector(chart.axis_v), at.shading_normal);
    const SurfacePoint<float> point{-direction, light.axis, at.shading_normal, false, {}};
    const std::uint32_t gloss_chart = context.bins.gloss_charts.index[at.hit.chart];
    std::array<float, static_cast<std::size_t>((components + 1) * bands)> weights;
    const auto fields = static_cast<std::size_t>(context.bins.gloss_fields.layout().fields);
    const bool coarse = context.bins.gloss_charts.coarse[gloss_chart];
    const std::uint32_t deposits = at.material->rough() ? gloss_deposits : 1;  // a mirror sends all light one way
    for (std::uint32_t k = 0; k < deposits; ++k) {
        const std::array<std::uint32_t, 4> words = philox(context.seed, photon, bounce, 2 + k);
        ScatterNumbers<float> numbers;
        numbers.slope = unit_float(words[0]);
        numbers.facet_u = unit_float(words[1]);
        numbers.facet_v = unit_float(words[2]);
        numbers.facet_w = unit_float(words[3]);
        const auto sample = sample_gloss<static_cast<std::size_t>(bands)>(*at.material, point, numbers);
        if (!sample.alive || (sample.sharp && !coarse) || !(dot(sample.direction, at.normal) > 0)) continue;
        PhotonLight<components, bands> sent = light;
        scatter_by(sample, sent);
        const Vector<float> frame = transported_axis(at.shading_normal, tangent_u, sample.direction);
        sent.gloss_fields(rotation_between(sample.direction, sample.axis, frame), ratio / static_cast<float>(deposits),
                          weights);
        const glm::vec2 square =
            direction_map::direction_square({dot(sample.direction, tangent_u), dot(sample.direction, tangent_v)});
        const BinTree<4>::Point place = {at.hit.u, at.hit.v, chart_fixed_point(square.x), chart_fixed_point(square.y)};
        const std::uint32_t leaf = context.bins.gloss.locate(gloss_chart, place);
        const Arrival arrival{0, 0, std::span(weights.data(), fields * bands),
                              static_cast<std::uint32_t>(photon % replica_count)};
        file_event<4>(context.bins.gloss, tally, leaf, place, arrival);
    }
}

/// Scatters the light at a surface. False where it ends: absorbed, or sent to the wrong side of the facet.
template <int components, int bands>
bool scatter(const TransportContext& context, const Meeting& at, const ScatterNumbers<float>& numbers, Ray& ray,
             PhotonLight<components, bands>& light, WorkerSums& sums) {
    const Vector<float> direction = float_vector(ray.direction);
    SurfacePoint<float> point{-direction, light.axis, at.shading_normal, at.inside, {}};
    if (at.material->filter != FilterKind::none) {
        const Vector<double> axis = filter_axis(*at.material, context.scene.charts[at.hit.chart]);
        point.filter_axis = float_vector(coordinates_of(axis));
    }
    const ScatterSample<float, static_cast<std::size_t>(bands)> sample =
        sample_bsdf<Use::light, static_cast<std::size_t>(bands)>(*at.material, point, numbers);
    const PhotonLight<components, bands> before = light;
    if (!sample.alive) {
        book(sums.ledger.absorbed, before);
        return false;
    }
    scatter_by(sample, light);
    if (!light.finite()) {
        ++sums.counts.trouble;
        book(sums.ledger.cut, before);
        return false;
    }
    book(sums.ledger.absorbed, before, light);
    if (sample.base && context.coloured) {
        const PhotonLight<components, bands> untinted = light;
        const glm::vec4 tint = tint_at(context.scene, at.hit.triangle, at.hit.b1, at.hit.b2);
        for (std::size_t b = 0; b < bands; ++b)
            light.scale_band(b, at.material->tinted_base(b, tint[static_cast<int>(b)]));
        book(sums.ledger.absorbed, untinted, light);
    }
    if ((dot(sample.direction, at.normal) > 0) == sample.refracted) {
        book(sums.ledger.cut, light);
        return false;
    }
    ray.origin = at.hit.position;
    ray.direction = glm_vector(sample.direction);
    ray.leaving = at.hit.triangle;
    if (at.hit.normal != at.hit.shading_normal) {
        const PhotonLight<components, bands> uncorrected = light;
        PhotonLight<components, bands> whole = light;
        whole.scale(cosine_ratio(direction, at) / cosine_ratio(sample.direction, at));
        light.scale(shading_normal_correction(direction, sample.direction, at.shading_normal, at.normal));
        if (!whole.finite()) whole = light;
        book(sums.ledger.shading, uncorrected, whole);
        book(sums.ledger.capped, whole, light);
    }
    return true;
}

/// Everything that the bins want to know of an arrival. False where they want nothing.
template <int components, int bands, bool gloss>
bool deposit_arrival(const TransportContext& context, const Meeting& at, const Ray& ray,
                     const PhotonLight<components, bands>& light, bool direct, std::uint64_t photon,
                     std::uint32_t bounce, WorkerSums& sums) {
    const Vector<float> direction = float_vector(ray.direction);
    bool filed = false;
    if (at.material->diffuse()) {
        deposit_entry(context, at, direction, light, direct, static_cast<std::uint32_t>(photon % replica_count),
                      sums.entry);
        filed = true;
    }
    if constexpr (gloss) {
        if (context.bins.gloss_charts.index[at.hit.chart] != no_chart) {
            deposit_gloss(context, at, direction, light, photon, bounce, sums.gloss);
            filed = true;
        }
    }
    return filed;
}

template <int components, int bands, bool gloss>
void trace_photon(const TransportContext& context, std::uint64_t photon, WorkerSums& sums) {
    const EmittedPhoton emitted = context.emission.sample(photon);
    Ray ray = emitted.ray;
    PhotonLight<components, bands> light = emitted_light<components, bands>(context.scene, emitted);
    const float reference = light.largest();
    bool direct = true, useful = false;
    ++sums.counts.photons;
    book(sums.ledger.emitted, light);

    for (std::uint32_t bounce = 0; bounce < bounce_limit; ++bounce) {
        Hit hit;
        ray.meets_holes = true;
        context.rays.intersect(std::span(&ray, 1), std::span(&hit, 1));
        ++sums.counts.rays;
        if (hit.escaped()) {
            book(sums.ledger.escaped, light);
            break;
        }
        if (hit.hole) {
            // Light passes, and is filed as if the surface went on there: cells need not know how much of them is cut.
            if (hit.chart != no_chart)
                deposit_arrival<components, bands, gloss>(context, meeting_of(context, hit), ray, light, direct, photon,
                                                          bounce, sums);
            ray.origin = hit.position;
            ray.leaving = hit.triangle;
            continue;
        }
        ++sums.counts.bounces;
        if (hit.chart == no_chart) {
            book(sums.ledger.absorbed, light);
            break;
        }
        const Meeting at = meeting_of(context, hit);
        if (hit.normal != hit.shading_normal && !(cosine_ratio(float_vector(ray.direction), at) > 0)) {
            book(sums.ledger.cut, light);
            break;
        }
        useful =
            deposit_arrival<components, bands, gloss>(context, at, ray, light, direct, photon, bounce, sums) || useful;
        const ScatterNumbers<float> numbers = scatter_numbers(context, photon, bounce, direct, at.material->rough());
        direct = false;
        if (!scatter(context, at, numbers, ray, light, sums)) break;

        const float left = light.largest();
        if (left < roulette_share * reference) {
            const float survival = left / reference;
            if (!(unit_float(philox(context.seed, photon, bounce, 0)[0]) < survival)) {
                book(sums.ledger.roulette, light);
                break;
            }
            const PhotonLight<components, bands> before = light;
            light.scale(1 / survival);
            book(sums.ledger.roulette, before, light);
        }
        if (bounce + 1 == bounce_limit) book(sums.ledger.cut, light);
    }
    if (useful) ++sums.counts.useful;
}

template <int components, int bands, bool gloss>
class ScalarTracer : public PhotonTracer {
    void trace(const TransportContext& context, std::uint64_t begin, std::uint64_t end, WorkerSums& sums) override {
        for (std::uint64_t photon = begin; photon < end; ++photon)
            trace_photon<components, bands, gloss>(context, photon, sums);
    }
};

template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> scalar_tracer() {
    return std::make_unique<ScalarTracer<components, bands, gloss>>();
}

}  // namespace brewster::transport
