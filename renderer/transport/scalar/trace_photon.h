#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "scene/vectors.h"
#include "transport/deposit.h"
#include "transport/emitted_light.h"
#include "transport/interaction.h"
#include "transport/kernel.h"

/// Transport of one photon at a time, written to be read; compiled once for each kernel (kernels/). What ships moves
/// photons in blocks and gives the same bits: this is its oracle.
namespace brewster::transport {

inline Meeting<float> meeting_of(const TransportContext& context, const Hit& hit) {
    const Scene& scene = context.scene;
    const Chart& chart = scene.charts[hit.chart];
    Meeting<float> at;
    at.material = &context.materials[chart.material];
    at.inside = is_inside(context, hit.triangle, hit.chart);
    at.position = float_vector(hit.position);
    at.normal = float_vector(hit.normal);
    at.shading_normal = float_vector(hit.shading_normal);
    at.triangle = hit.triangle;
    at.chart = hit.chart;
    at.u = hit.u;
    at.v = hit.v;
    at.barycentric = {hit.b1, hit.b2};
    at.chart_normal = float_vector(chart.normal);
    at.axis_u = float_vector(chart.axis_u);
    at.axis_v = float_vector(chart.axis_v);
    at.filter_axis = filter_axis_of(context, hit.chart);
    return at;
}

/// Files what enters the base.
template <int components, int bands>
void deposit_entry(const TransportContext& context, const Hit& hit, const Meeting<float>& at,
                   const Flight<float, components, bands>& flight, std::uint32_t replica, Tally<2>& tally) {
    const EnteringLight<float, bands> entering =
        entering_light<float, components, bands>(at, flight.direction, flight.light);
    if (!entering.filed) return;
    const int worlds = context.bins.entry_fields.worlds(flight.direct ? 0 : 1);
    deposit(context.bins.entry, context.bins.entry_fields, tally, hit,
            std::span(entering.weights.data(), static_cast<std::size_t>(worlds * bands)), flight.direct, replica);
}

/// Files what the interface sends on.
template <int components, int bands>
void deposit_gloss(const TransportContext& context, const Meeting<float>& at,
                   const Flight<float, components, bands>& flight, const Event<float, bands>& event,
                   std::uint32_t replica, Tally<4>& tally) {
    const std::uint32_t chart = context.bins.gloss_charts.index[at.chart];
    const bool coarse = context.bins.gloss_charts.coarse[chart];
    const GlossFrame<float> frame = gloss_frame(at, flight.direction);
    const std::uint32_t deposits = deposits_of(*at.material, coarse);
    const float share = 1.0f / static_cast<float>(deposits);
    for (std::uint32_t k = 0; k < deposits; ++k) {
        const GlossLight<float, components, bands> gloss =
            gloss_light(at, frame, flight.light, lobe_sample(context, at, flight, event, k), coarse, share);
        if (!gloss.filed) continue;
        const BinTree<4>::Point place = {at.u, at.v, gloss.square[0], gloss.square[1]};
        file_event<4>(context.bins.gloss, tally, context.bins.gloss.locate(chart, place), place,
                      {0, 0, gloss.weights, replica});
    }
}

/// Everything that the bins want to know of an arrival. False where they want nothing.
template <int components, int bands, bool gloss>
bool deposit_arrival(const TransportContext& context, const Hit& hit, const Meeting<float>& at,
                     const Flight<float, components, bands>& flight, const Event<float, bands>& event,
                     std::uint64_t photon, WorkerSums& sums) {
    const auto replica = static_cast<std::uint32_t>(photon % replica_count);
    bool filed = false;
    if (at.material->diffuse()) {
        deposit_entry<components, bands>(context, hit, at, flight, replica, sums.entry);
        filed = true;
    }
    if constexpr (gloss) {
        if (context.bins.gloss_charts.index[at.chart] != no_chart) {
            deposit_gloss<components, bands>(context, at, flight, event, replica, sums.gloss);
            filed = true;
        }
    }
    return filed;
}

/// `meet(hit, at, flight)` files what arrives and sends it on; true where something was filed.
template <int components, int bands, bool gloss, class Meet>
void trace_photon(const TransportContext& context, std::uint64_t photon, Books<float>& books, WorkerSums& sums,
                  const Meet& meet) {
    const EmittedPhoton<float> emitted = context.emission.sample(photon);
    Ray ray = first_ray(emitted);
    Flight<float, components, bands> flight;
    flight.direction = float_vector(ray.direction);
    flight.light = emitted_light<components, bands>(context.scene, context.emission, emitted);
    flight.reference = flight.light.largest();
    flight.key = {static_cast<std::uint32_t>(photon), static_cast<std::uint32_t>(photon >> 32), 0};
    flight.alive = flight.direct = true;
    bool useful = false;
    ++sums.counts.photons;
    ++sums.guide.traced[emitted.guide_cell];
    books.take(&Ledger::emitted, true, flight.light);

    for (; flight.alive; ++flight.key.bounce) {
        Hit hit;
        context.rays.intersect(std::span(&ray, 1), std::span(&hit, 1));
        ++sums.counts.rays;
        if (hit.escaped()) {
            books.take(&Ledger::escaped, true, flight.light);
            break;
        }
        if (hit.hole) {
            // Light passes, and is filed as if the surface went on there: cells need not know how much of them is cut.
            if (hit.chart != no_chart) {
                const Meeting<float> at = meeting_of(context, hit);
                deposit_arrival<components, bands, gloss>(context, hit, at, flight, event_at(context, at, flight),
                                                          photon, sums);
            }
            ray.origin = hit.position;
            ray.leaving = hit.triangle;
            continue;
        }
        ++sums.counts.bounces;
        if (hit.chart == no_chart) {
            books.take(&Ledger::absorbed, true, flight.light);
            break;
        }
        const Meeting<float> at = meeting_of(context, hit);
        cut_turned_away(at, flight, books);
        if (!flight.alive) break;
        useful = meet(hit, at, flight) || useful;
        ray.origin = hit.position;
        ray.direction = glm_vector(flight.direction);
        ray.leaving = hit.triangle;
    }
    if (useful) {
        ++sums.counts.useful;
        ++sums.guide.useful[emitted.guide_cell];
    }
}

template <int components, int bands, bool gloss>
class ScalarTracer : public PhotonTracer {
    void trace(const TransportContext& context, std::uint64_t begin, std::uint64_t end, WorkerSums& sums) override {
        for (std::uint64_t photon = begin; photon < end; ++photon) {
            Books<float> books;
            const auto meet = [&](const Hit& hit, const Meeting<float>& at, Flight<float, components, bands>& flight) {
                const Event<float, bands> event = event_at(context, at, flight);
                const bool filed =
                    deposit_arrival<components, bands, gloss>(context, hit, at, flight, event, photon, sums);
                go_on(context, at, event, flight, books, sums.counts);
                return filed;
            };
            trace_photon<components, bands, gloss>(context, photon, books, sums, meet);
            books.close(sums.ledger);
        }
    }
};

template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> scalar_tracer() {
    return std::make_unique<ScalarTracer<components, bands, gloss>>();
}

}  // namespace brewster::transport
