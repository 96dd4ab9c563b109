#pragma once
#include <algorithm>

#include "gather/bin_light.h"
#include "gather/eye_level.h"
#include "scene/bsdf.h"

/// What happens at the entries of a group, all of one material and side: one formula for a float and for lanes.
namespace brewster {

template <class Real>
using Bands = std::array<PlanarMueller<Real>, band_count>;

template <int components, class Real>
void add_stokes(Rows<12>& rows, std::size_t band, std::size_t i, const Stokes<Real, components>& light) {
    for (std::size_t j = 0; j < components; ++j) {
        float* at = &rows[3 * j + band][i];
        store(load<Real>(at) + light[static_cast<int>(j)], at);
    }
}
template <class Real>
void add(Rows<3>& rows, std::size_t band, std::size_t i, const Real& value) {
    float* at = &rows[band][i];
    store(load<Real>(at) + value, at);
}
/// Errors of independent causes.
template <class Real>
void add_error(Rows<3>& rows, std::size_t band, std::size_t i, const Real& error) {
    float* at = &rows[band][i];
    const Real before = load<Real>(at);
    store(sqrt(fma(before, before, error * error)), at);
}

/// Adds to `light` what the base sends back of the light that has entered it (theory 5; rough interface: 3.9).
template <int components, class Real>
void add_base(const PreparedMaterial& material, bool tinted, const Entered& entered, const Level& level,
              LevelLight& light, std::size_t i) {
    const Vector<Real> light_out = -load_vector<Real>(level.direction, i);
    const Vector<Real> normal = load_vector<Real>(level.shading_normal, i);
    const Real cosine = min(dot(light_out, normal), Real(1));
    FrameRotation<Real> turn;
    if (components > 1 && material.reflects())
        turn = rotation_between(light_out, axis_across(light_out, normal), load_vector<Real>(level.axis, i));
    for (std::size_t band = 0; band < band_count; ++band) {
        const Passage<Real> out = material.passage(band, cosine);
        Real factor(material.base_factor[band]);
        if (tinted) factor = factor * load<Real>(&level.tint[band][i]);
        const Real whole = factor * out.unpolarized, polarized = factor * out.s_minus_p;
        const Real on = load<Real>(&entered.value[0][band][i]);
        const Real error = load<Real>(&entered.error[0][band][i]);
        add_error(light.error, band, i, whole * error);
        if constexpr (components == 1) {
            add_stokes(light.stokes, band, i, Stokes<Real, 1>{{whole * on}});
        } else {
            const auto s = rotate(turn, stokes_of<components>(whole * on, polarized * on, Real(0), Real(0)));
            add_stokes(light.stokes, band, i, s);
            add_error(light.polarized_error, band, i, polarized * error);
            add(light.unpolarized, band, i, whole * load<Real>(&entered.value[1][band][i]));
            add_error(light.unpolarized_error, band, i, whole * load<Real>(&entered.error[1][band][i]));
        }
    }
}

/// Power heuristic: the share of the technique that drew the direction (Veach 1997).
template <class Real>
Real heuristic_share(const Real& own, const Real& other) {
    return own * own / max(fma(own, own, other * other), constant<Real>(1e-30));
}

/// Wide rays are weighed as if there were so many times as many: they speak only where the lobe hardly ever draws, and
/// leave to it what it draws well.
inline constexpr double wide_trust = 0.5;

/// What counts as the density of wide rays, 1/sr, beside that of a gloss's lobe.
template <class Real>
Real wide_density(const Real& wide_share, const Real& cosine) {
    return wide_share * (constant<Real>(wide_trust / pi) * cosine);
}
/// What counts as the density of lobe and wide rays together, beside that of points on lamps.
template <class Real>
Real joint_density(const Real& of_lobe, const Real& wide) {
    return sqrt(fma(wide, wide, of_lobe * of_lobe));
}

/// A point on a lamp for each entry, and what its light becomes there, before anything stands in its way.
struct LampSamples {
    Rows<3> direction;                      ///< unit, towards the lamp
    Rows<3> radiance;                       ///< over the density of the direction; zero: none
    std::array<float, most_rays> pdf;       ///< of the direction, 1/sr; 0 of a lamp without extent
    Rows<3> state, axis;                    ///< S1, S2, S3 over S0 and the axis they refer to; of polarized lamps only
    std::array<float, most_rays> distance;  ///< metres; infinite of a sun
    std::array<std::uint32_t, most_rays> lamp;
    Rows<12> stokes;  ///< what reaches the entry's ray
    Rows<3> unpolarized;
};

/// The lobes' light of the sampled lamps: of the base where its bins do not tell their light, and of the gloss.
template <int components, class Real>
void light_by_lamps(const PreparedMaterial& material, bool tinted, bool polarized_lamps, const Level& level,
                    LampSamples& lamps, std::size_t i) {
    const Vector<Real> light_in = -load_vector<Real>(lamps.direction, i);
    const Vector<Real> light_out = -load_vector<Real>(level.direction, i);
    const Vector<Real> normal = load_vector<Real>(level.shading_normal, i);
    const Vector<Real> axis = load_vector<Real>(level.axis, i);
    const Real cosine = max(-dot(light_in, normal), Real(0));
    std::array<Stokes<Real, components>, band_count> sum{};
    std::array<Real, band_count> unpolarized_sum{};
    const auto see = [&](const LobeValue<Real, band_count>& lobe, const Real& weight, bool base) {
        FrameRotation<Real> out, in;
        if constexpr (components > 1) {
            out = rotation_between(light_out, lobe.axis_out, axis);
            if (polarized_lamps) in = rotation_between(light_in, load_vector<Real>(lamps.axis, i), lobe.axis_in);
        }
        for (std::size_t band = 0; band < band_count; ++band) {
            Real incident = weight * cosine * load<Real>(&lamps.radiance[band][i]);
            if (base && tinted) incident = incident * load<Real>(&level.tint[band][i]);
            Stokes<Real, components> state = unpolarized<components>(Real(1));
            if (components > 1 && polarized_lamps)
                state =
                    rotate(in, stokes_of<components>(Real(1), load<Real>(&lamps.state[0][i]),
                                                     load<Real>(&lamps.state[1][i]), load<Real>(&lamps.state[2][i])));
            sum[band] = sum[band] + incident * rotate(out, lobe.value[band] * state);
            unpolarized_sum[band] = unpolarized_sum[band] + incident * lobe.value[band].m00;
        }
    };
    if (material.diffuse()) {
        const Real wanted = 1 - load<Real>(&level.reads_direct[i]);
        see(evaluate_base<Use::eye, band_count>(material, light_in, light_out, normal), wanted, true);
    }
    if (material.rough()) {
        const auto gloss = evaluate_gloss<Use::eye, band_count>(material, light_in, light_out, normal);
        const Real pdf = load<Real>(&lamps.pdf[i]);
        const Real of_rays = joint_density(gloss.pdf, wide_density(load<Real>(&level.wide_share[i]), cosine));
        see(gloss, select(pdf > 0, heuristic_share(pdf, of_rays), Real(1)), false);
    }
    for (std::size_t band = 0; band < band_count; ++band) {
        for (std::size_t j = 0; j < components; ++j)
            store(sum[band][static_cast<int>(j)], &lamps.stokes[3 * j + band][i]);
        store(unpolarized_sum[band], &lamps.unpolarized[band][i]);
    }
}

/// Where rays go on to, one way.
struct Onwards {
    Rows<3> direction, axis;
    std::array<float, most_rays> pdf, share;  ///< share: the most that comes through of any light; 0: the path ends
    std::array<float, most_rays> sharp;       ///< 1 or 0
};

/// Numbers of the events of a level.
struct EventNumbers {
    std::array<float, most_rays> facet_u, facet_v, choice, slope, exit_u, exit_v;
};

template <class Real>
SurfacePoint<Real> surface_point(const PreparedMaterial& material, bool inside, const Level& level, std::size_t i) {
    SurfacePoint<Real> at;
    at.towards = -load_vector<Real>(level.direction, i);
    at.carried_axis = load_vector<Real>(level.axis, i);
    at.normal = load_vector<Real>(level.shading_normal, i);
    at.inside = inside;
    if (material.filter != FilterKind::none) at.filter_axis = load_vector<Real>(level.filter_axis, i);
    return at;
}

/// Puts a way on into the level and `onwards`.
template <class Real>
void take_way(const ScatterSample<Real, band_count>& sample, std::size_t way, Level& level, Onwards& onwards,
              std::size_t i) {
    const std::size_t at = way * most_rays + i;
    Real share(0);
    for (std::size_t band = 0; band < band_count; ++band) {
        level.set_event(band, at, sample.weight[band]);
        share = max(share, sample.weight[band].m00 + abs(sample.weight[band].m01));
    }
    store(sample.turn.cos_2t, &level.turn_cos[at]);
    store(sample.turn.sin_2t, &level.turn_sin[at]);
    store_vector(sample.direction, onwards.direction, i);
    store_vector(sample.axis, onwards.axis, i);
    store(sample.pdf, &onwards.pdf[i]);
    // A shading normal can point a ray to the wrong side of the facet; it is absorbed there.
    const Real side = dot(sample.direction, load_vector<Real>(level.normal, i));
    const auto right_side = (side > 0 && !sample.refracted) || (!(side > 0) && sample.refracted);
    store(select(sample.alive && right_side, share, Real(0)), &onwards.share[i]);
    store(select(sample.sharp, Real(1), Real(0)), &onwards.sharp[i]);
}

/// Samples where light of the base comes from, by the cosine, as the second way on.
template <class Real>
void go_into_base(const PreparedMaterial& material, bool tinted, const EventNumbers& numbers, Level& level,
                  Onwards& onwards, std::size_t i) {
    const SurfacePoint<Real> at = surface_point<Real>(material, false, level, i);
    ScatterNumbers<Real> drawn;
    drawn.exit_u = load<Real>(&numbers.exit_u[i]);
    drawn.exit_v = load<Real>(&numbers.exit_v[i]);
    const PlaneOfIncidence<Real> plane = plane_of_incidence(-at.towards, at.carried_axis, at.normal);
    auto sample = sample_base<Use::eye, band_count>(material, at, plane, drawn);
    if (tinted)
        for (std::size_t band = 0; band < band_count; ++band)
            sample.weight[band] = load<Real>(&level.tint[band][i]) * sample.weight[band];
    take_way(sample, 1, level, onwards, i);
}

/// Both ways of a path that parts: the stronger one always, the weaker one with `eagerness` times its share as
/// probability.
template <class Real>
std::array<ScatterSample<Real, band_count>, 2> parted_ways(const PreparedMaterial& material,
                                                           const SurfacePoint<Real>& at, const Real& choice,
                                                           const Real& eagerness) {
    auto ways = both_ways<Use::eye, band_count>(material, at);
    const Real reflected = ways[0].weight[0].m00, refracted = 1 - reflected;
    const Real followed = min(eagerness * min(reflected, refracted), Real(1));
    const Real enlarged = 1 / max(followed, constant<Real>(1e-30));
    const std::array<MaskOf<Real>, 2> weaker = {reflected < refracted, !(reflected < refracted)};
    for (std::size_t way = 0; way < 2; ++way) {
        for (PlanarMueller<Real>& weight : ways[way].weight) weight = select(weaker[way], enlarged, Real(1)) * weight;
        ways[way].alive = ways[way].alive && (choice < followed || !weaker[way]);
    }
    return ways;
}

/// Samples where gloss's light comes from by the cosine, from two uniform numbers, as the second way on: from where its
/// lobe points too seldom for what glares there.
inline void leave_gloss_widely(const PreparedMaterial& material, const std::array<float, 2>& numbers, Level& level,
                               Onwards& onwards, std::size_t i) {
    const SurfacePoint<float> at = surface_point<float>(material, false, level, i);
    const auto drawn = sample_cosine(at.normal, axis_across(-at.towards, at.normal), numbers[0], numbers[1]);
    const auto gloss = evaluate_gloss<Use::eye, band_count>(material, -drawn.direction, at.towards, at.normal);
    const float wide = wide_density(level.wide_share[i], drawn.cosine);
    // Over the true density of wide rays, not that which is trusted.
    const float factor =
        heuristic_share(wide, gloss.pdf) * static_cast<float>(wide_trust) * drawn.cosine / std::max(wide, 1e-30f);
    ScatterSample<float, band_count> sample;
    sample.direction = drawn.direction;
    sample.axis = gloss.axis_in;
    sample.turn = rotation_between(at.towards, gloss.axis_out, at.carried_axis);
    for (std::size_t band = 0; band < band_count; ++band) sample.weight[band] = factor * gloss.value[band];
    sample.pdf = joint_density(gloss.pdf, wide);
    sample.alive = gloss.pdf > 0;
    sample.sharp = sample.base = sample.refracted = false;
    take_way(sample, 1, level, onwards, i);
}

/// Samples where the interface's light comes from: mirror, refraction or one facet. What is transparent sends it both
/// ways where the path may part.
template <class Real>
void go_on(const PreparedMaterial& material, bool inside, const EventNumbers& numbers, Level& level,
           std::array<Onwards, 2>& onwards, std::size_t i) {
    const SurfacePoint<Real> at = surface_point<Real>(material, inside, level, i);
    ScatterNumbers<Real> drawn;
    drawn.choice = load<Real>(&numbers.choice[i]);
    drawn.facet_u = load<Real>(&numbers.facet_u[i]);
    drawn.facet_v = load<Real>(&numbers.facet_v[i]);
    drawn.slope = load<Real>(&numbers.slope[i]);
    if (material.base != Base::transparent) {
        auto sample = sample_gloss<band_count, FacetDraw::smooth>(material, at, drawn);
        const Real wide =
            wide_density(load<Real>(&level.wide_share[i]), max(dot(sample.direction, at.normal), Real(0)));
        const Real share = select(sample.pdf > 0, heuristic_share(sample.pdf, wide), Real(1));
        for (PlanarMueller<Real>& weight : sample.weight) weight = share * weight;
        sample.pdf = select(sample.pdf > 0, joint_density(sample.pdf, wide), Real(0));
        take_way(sample, 0, level, onwards[0], i);
        return;
    }
    const Real eagerness = load<Real>(&level.eagerness[i]);
    const auto parts = eagerness > 0;
    const auto drawn_way = [&] { return sample_bsdf<Use::eye, band_count>(material, at, drawn); };
    ScatterSample<Real, band_count> first;
    if (any_of(parts) && material.filter == FilterKind::none) {
        auto ways = parted_ways(material, at, drawn.choice, eagerness);
        ways[1].alive = ways[1].alive && parts;
        first = any_of(!parts) ? select_sample<band_count, Real>(parts, ways[0], drawn_way()) : ways[0];
        take_way(ways[1], 1, level, onwards[1], i);
    } else {
        first = drawn_way();
        store(Real(0), &onwards[1].share[i]);
    }
    take_way(first, 0, level, onwards[0], i);
}

/// Brings what came along rays k of the next level to their parents: by the parents' events into the frames of their
/// rays. It stands in `brought` until it is added.
template <int components, class Real>
void bring_back(const Level& next, std::size_t k, LevelLight& brought, const Level& level) {
    const Word<Real> way = load_word<Real>(&next.parent_way[k]);
    const auto of_parent = [&](const Level::Ways& row) { return entries_of<Real>(row, way); };
    const LevelLight& light = next.light;
    const FrameRotation<Real> turn{of_parent(level.turn_cos), of_parent(level.turn_sin)};
    Real coarse(0);
    for (std::size_t band = 0; band < band_count; ++band) {
        const auto row = [&](std::size_t element) { return of_parent(level.event[6 * band + element]); };
        const PlanarMueller<Real> event = {row(0), row(1), row(2), row(3), row(4), row(5)};
        Stokes<Real, components> arriving{};
        for (std::size_t j = 0; j < components; ++j)
            arriving[static_cast<int>(j)] = load<Real>(&light.stokes[3 * j + band][k]);
        const auto leaving = rotate(turn, event * arriving);
        for (std::size_t j = 0; j < components; ++j)
            store(leaving[static_cast<int>(j)], &brought.stokes[3 * j + band][k]);
        const Real error = load<Real>(&light.error[band][k]);
        if constexpr (components == 1) {
            store(event.m00 * error, &brought.error[band][k]);
        } else {
            const Real polarized = load<Real>(&light.polarized_error[band][k]);
            store(event.m00 * load<Real>(&light.unpolarized[band][k]), &brought.unpolarized[band][k]);
            store(event.m00 * load<Real>(&light.unpolarized_error[band][k]), &brought.unpolarized_error[band][k]);
            store(event.m00 * error + abs(event.m01) * polarized, &brought.error[band][k]);
            const Real across = abs(event.c) + abs(event.d);
            store(max(abs(event.m10) * error + abs(event.m11) * polarized, across * polarized),
                  &brought.polarized_error[band][k]);
        }
        coarse = max(coarse, event.m00);
    }
    store(coarse * load<Real>(&light.coarse[k]), &brought.coarse[k]);
}

template <int components>
void add_brought(const Level& next, const LevelLight& brought, Level& level) {
    const auto add_rows = [&](const auto& from, auto& to, std::size_t rows) {
        for (std::size_t row = 0; row < rows; ++row)
            for (std::uint32_t k = 0; k < next.size; ++k) to[row][next.parent[k]] += from[row][k];
    };
    const auto add_errors = [&](const Rows<3>& from, Rows<3>& to) {
        for (std::size_t band = 0; band < band_count; ++band)
            for (std::uint32_t k = 0; k < next.size; ++k) {
                float& error = to[band][next.parent[k]];
                error = std::sqrt(error * error + from[band][k] * from[band][k]);
            }
    };
    add_rows(brought.stokes, level.light.stokes, 3 * components);
    add_errors(brought.error, level.light.error);
    if constexpr (components > 1) {
        add_rows(brought.unpolarized, level.light.unpolarized, 3);
        add_errors(brought.polarized_error, level.light.polarized_error);
        add_errors(brought.unpolarized_error, level.light.unpolarized_error);
    }
    for (std::uint32_t k = 0; k < next.size; ++k) level.light.coarse[next.parent[k]] += brought.coarse[k];
}

}  // namespace brewster
