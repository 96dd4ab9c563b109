#pragma once
#include <array>
#include <bit>

#include "scene/albedo.h"
#include "transport/arrival.h"
#include "transport/books.h"

/// What happens to photons where they meet a surface, written once: for one photon, and for a batch of lanes on one
/// material and side of it. Masks say which lanes take part; one photon is a batch of one.
namespace brewster::transport {

inline constexpr std::uint32_t bounce_limit = 1u << 16;  // no room is this bright; what is left there is booked as cut
inline constexpr double roulette_share = 0.25;           // of the weight at emission, below which the roulette begins

inline std::uint64_t count_of(bool mask) {
    return mask ? 1 : 0;
}
inline std::uint64_t count_of(const LaneMask& mask) {
    return static_cast<std::uint64_t>(std::popcount(bits_of(mask)));
}

/// What goes in and out of an event.
template <class Real, int components, int bands>
struct Flight {
    Vector<Real> direction;
    PhotonLight<Real, components, bands> light;
    Real reference;  ///< the largest power at emission
    Key<Real> key;
    MaskOf<Real> alive;   ///< on its way; all others are booked
    MaskOf<Real> direct;  ///< nothing was met before
};

/// tint_at of each lane of `mask`, 1 elsewhere.
inline std::array<float, band_count> tints(const Scene& scene, const Meeting<float>& at, bool mask) {
    if (!mask) return {1, 1, 1};
    const glm::vec4 tint = tint_at(scene, at.triangle, at.barycentric.b1, at.barycentric.b2);
    return {tint.x, tint.y, tint.z};
}
inline std::array<FloatLanes, band_count> tints(const Scene& scene, const Meeting<FloatLanes>& at,
                                                const LaneMask& mask) {
    std::array<std::uint32_t, lane_count> triangles;
    std::array<float, lane_count> b1, b2;
    store(at.triangle, triangles.data());
    store(at.barycentric.b1, b1.data());
    store(at.barycentric.b2, b2.data());
    std::array<std::array<float, lane_count>, band_count> tint;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        glm::vec4 of_lane(1.0f);
        if (bits_of(mask) >> lane & 1u) of_lane = tint_at(scene, triangles[lane], b1[lane], b2[lane]);
        for (std::size_t band = 0; band < band_count; ++band) tint[band][lane] = of_lane[static_cast<int>(band)];
    }
    return {load<FloatLanes>(tint[0].data()), load<FloatLanes>(tint[1].data()), load<FloatLanes>(tint[2].data())};
}

/// What a base under a texture or coloured corners keeps of light that it scatters, per band.
template <class Real, int components, int bands>
void tint_base(const TransportContext& context, const Meeting<Real>& at, const MaskOf<Real>& base,
               PhotonLight<Real, components, bands>& light, Books<Real>& books) {
    if (!context.coloured || !any_of(base)) return;
    const std::array<Real, band_count> tint = tints(context.scene, at, base);
    const PhotonLight<Real, components, bands> untinted = light;
    for (std::size_t b = 0; b < bands; ++b)
        light.scale_band(b, select(base, at.material->tinted_base(b, tint[b]), Real(1)));
    books.take(&Ledger::absorbed, base, untinted, light);
}

/// Scatters the light the way that was drawn. It ends where it is absorbed, or sent to the wrong side of the facet.
template <class Real, int components, int bands>
void scatter(const TransportContext& context, const Meeting<Real>& at, const Sample<Real, bands>& sample,
             Flight<Real, components, bands>& flight, Books<Real>& books, TransportCounts& counts) {
    using Light = PhotonLight<Real, components, bands>;
    const Light before = flight.light;
    Light& light = flight.light;
    scatter_by(sample, light);
    const MaskOf<Real> survives = flight.alive && sample.alive;
    const MaskOf<Real> sound = survives && light.in_range();
    books.take(&Ledger::absorbed, flight.alive && !survives, before);
    books.take(&Ledger::cut, survives && !sound, before);
    counts.trouble += count_of(survives && !sound);
    books.take(&Ledger::absorbed, sound, before, light);
    tint_base(context, at, MaskOf<Real>(sound && sample.base), light, books);

    const auto upwards = dot(sample.direction, at.normal) > 0;
    const MaskOf<Real> wrong = sound && ((upwards && sample.refracted) || (!upwards && !sample.refracted));
    books.take(&Ledger::cut, wrong, light);
    flight.alive = sound && !wrong;
    const MaskOf<Real> bent = flight.alive && is_bent(at);
    if (any_of(bent)) {
        const Light uncorrected = light;
        Light whole = light, capped = light;
        whole.scale(cosine_ratio(flight.direction, at) / cosine_ratio(sample.direction, at));
        capped.scale(shading_normal_correction(flight.direction, sample.direction, at.shading_normal, at.normal));
        light = select(bent, capped, light);
        whole = select(MaskOf<Real>(bent && whole.in_range()), whole, light);
        books.take(&Ledger::shading, bent, uncorrected, whole);
        books.take(&Ledger::capped, bent, whole, light);
    }
    flight.direction = sample.direction;
}

/// Ends light below `share` of what it was at emission, or raises what survives, so that nothing is lost on average.
template <class Real, int components, int bands>
void roulette(const Real& number, double share, Flight<Real, components, bands>& flight, Books<Real>& books) {
    const Real left = flight.light.largest();
    const MaskOf<Real> weak = flight.alive && left < constant<Real>(share) * flight.reference;
    if (!any_of(weak)) return;
    const Real survival = left / flight.reference;
    const MaskOf<Real> saved = weak && number < survival;
    const MaskOf<Real> lost = weak && !saved;
    books.take(&Ledger::roulette, lost, flight.light);
    const PhotonLight<Real, components, bands> before = flight.light;
    PhotonLight<Real, components, bands> raised = flight.light;
    raised.scale(1 / survival);
    flight.light = select(saved, raised, flight.light);
    books.take(&Ledger::roulette, saved, before, flight.light);
    flight.alive = flight.alive && !lost;
}

/// Cuts light that meets a smooth mesh where its shading normal turns away.
template <class Real, int components, int bands>
void cut_turned_away(const Meeting<Real>& at, Flight<Real, components, bands>& flight, Books<Real>& books) {
    const MaskOf<Real> turned = flight.alive && is_bent(at) && !(cosine_ratio(flight.direction, at) > 0);
    books.take(&Ledger::cut, turned, flight.light);
    flight.alive = flight.alive && !turned;
}

template <class Real, int components, int bands>
Event<Real, bands> event_at(const TransportContext& context, const Meeting<Real>& at,
                            const Flight<Real, components, bands>& flight) {
    Event<Real, bands> event;
    event.numbers = event_numbers<Real>(context, flight.key, flight.direct, at.material->rough());
    if (has_gloss(*at.material))
        event.gloss =
            glossy<Real, bands>(*at.material, surface_point(at, flight.direction, flight.light), event.numbers.scatter);
    return event;
}

/// Direction k of those that an arrival files; the first is the event's own.
template <class Real, int components, int bands>
Sample<Real, bands> lobe_sample(const TransportContext& context, const Meeting<Real>& at,
                                const Flight<Real, components, bands>& flight, const Event<Real, bands>& event,
                                std::uint32_t k) {
    if (k == 0) return event.gloss;
    return glossy<Real, bands>(*at.material, surface_point(at, flight.direction, flight.light),
                               lobe_numbers<Real>(context, flight.key, k));
}

/// The way on that is drawn among all lobes.
template <class Real, int components, int bands>
Sample<Real, bands> way_on(const Meeting<Real>& at, const Flight<Real, components, bands>& flight,
                           const Event<Real, bands>& event) {
    return scattered<Real, bands>(*at.material, surface_point(at, flight.direction, flight.light),
                                  event.numbers.scatter, event.gloss);
}

/// The end of an event: nothing goes on for ever, and nothing that goes on is direct.
template <class Real, int components, int bands>
void grow_older(Flight<Real, components, bands>& flight, Books<Real>& books) {
    const MaskOf<Real> tired = flight.alive && equal(flight.key.bounce, Word<Real>(std::uint32_t{bounce_limit - 1}));
    books.take(&Ledger::cut, tired, flight.light);
    flight.alive = flight.alive && !tired;
    flight.direct = flight.direct && !flight.direct;
}

/// From the arrival to the way on.
template <class Real, int components, int bands>
void go_on(const TransportContext& context, const Meeting<Real>& at, const Event<Real, bands>& event,
           Flight<Real, components, bands>& flight, Books<Real>& books, TransportCounts& counts) {
    scatter(context, at, way_on(at, flight, event), flight, books, counts);
    roulette(event.numbers.roulette, roulette_share, flight, books);
    grow_older(flight, books);
}

}  // namespace brewster::transport
