#pragma once
#include "optics/axis_across.h"
#include "optics/inverted_slopes.h"
#include "optics/planar_mueller.h"
#include "optics/thin_pane.h"
#include "scene/prepared_material.h"

/// The one BSDF (theory 2, 3.8, 3.9, 5), for photons, display and reference alike: evaluate, density, sample.
///
/// A material has up to two lobes between two directions of one side: what the interface reflects (*gloss*, or a sharp
/// *mirror*) and what the *base* sends back. Each lobe is a PlanarMueller a band, in light order, between the s frames
/// of its two segments. The polarized world multiplies its Stokes vectors by the matrix, the unpolarized one its power
/// by m00: both are divided by the same density, so that one path carries both.
///
/// Two uses: from the *light*, which arrives and is sampled onwards, and from the *eye*, whose direction is known and
/// where light comes from is sampled. `towards` is the known direction and `direction` the sampled one, both unit and
/// away from the surface. Weights map power on the light's side and radiance on the eye's; they differ where light
/// changes medium (factor (n_eye/n_light)^2).
/// `Real` may be a batch of lanes as long as all lie on one material and side.
namespace brewster {

enum class Use { light, eye };

/// How facets are drawn: quickly, or so that near numbers give near facets, from two of the numbers of a facet (not for
/// double).
enum class FacetDraw { quick, smooth };

template <class Real>
using MaskOf = decltype(std::declval<Real>() < std::declval<Real>());

/// Where a path meets a surface.
template <class Real>
struct SurfacePoint {
    Vector<Real> towards;        ///< unit, away from the surface: where the path comes from
    Vector<Real> carried_axis;   ///< of that segment; unit, orthogonal to it
    Vector<Real> normal;         ///< unit, shading normal of the side that was hit
    bool inside = false;         ///< the path runs inside a closed transparent body, whose skin it meets
    Vector<Real> filter_axis{};  ///< of a filter sheet (scene/filter_axis.h)
};

/// Uniform numbers in [0, 1) for one event. Smooth surfaces look at the first three only.
template <class Real>
struct ScatterNumbers {
    Real choice{}, exit_u{}, exit_v{}, slope{}, facet_u{}, facet_v{}, facet_w{};
};

/// How a path goes on.
template <class Real, std::size_t bands>
struct ScatterSample {
    Vector<Real> direction;    ///< unit, away from the surface
    Vector<Real> axis;         ///< the s axis of that segment
    FrameRotation<Real> turn;  ///< light: carried axis -> s axis of its segment; eye: that s axis -> carried axis
    std::array<PlanarMueller<Real>, bands> weight;  ///< f cos / density, all discrete choices included
    Real pdf;                ///< density of `direction` by its lobe, 1/sr, times the lobe's probability; sharp: 0
    MaskOf<Real> alive;      ///< false: absorbed, or below the horizon
    MaskOf<Real> sharp;      ///< by mirror or refraction: no other way of sampling finds this direction
    MaskOf<Real> base;       ///< by the depolarizing base
    MaskOf<Real> refracted;  ///< to the other side
};

/// By lanes, `a` where the mask holds, else `b`.
template <std::size_t bands, class Real>
ScatterSample<Real, bands> select_sample(const MaskOf<Real>& mask, const ScatterSample<Real, bands>& a,
                                         const ScatterSample<Real, bands>& b) {
    ScatterSample<Real, bands> chosen;
    chosen.direction = select(mask, a.direction, b.direction);
    chosen.axis = select(mask, a.axis, b.axis);
    chosen.turn = {select(mask, a.turn.cos_2t, b.turn.cos_2t), select(mask, a.turn.sin_2t, b.turn.sin_2t)};
    for (std::size_t band = 0; band < bands; ++band) chosen.weight[band] = select(mask, a.weight[band], b.weight[band]);
    chosen.pdf = select(mask, a.pdf, b.pdf);
    chosen.alive = (mask && a.alive) || (!mask && b.alive);
    chosen.sharp = (mask && a.sharp) || (!mask && b.sharp);
    chosen.base = (mask && a.base) || (!mask && b.base);
    chosen.refracted = (mask && a.refracted) || (!mask && b.refracted);
    return chosen;
}

namespace bsdf_detail {

template <std::size_t bands, class Real>
Real band_mean(const std::array<Real, bands>& values) {
    Real sum = values[0];
    for (std::size_t band = 1; band < bands; ++band) sum = sum + values[band];
    return sum * constant<Real>(1.0 / static_cast<double>(bands));
}

template <std::size_t bands, class Real>
Real band_mean(const std::array<PlanarMueller<Real>, bands>& matrices) {
    Real sum = matrices[0].m00;
    for (std::size_t band = 1; band < bands; ++band) sum = sum + matrices[band].m00;
    return sum * constant<Real>(1.0 / static_cast<double>(bands));
}

template <std::size_t bands, class Real>
void scale(std::array<PlanarMueller<Real>, bands>& matrices, const Real& by) {
    for (PlanarMueller<Real>& matrix : matrices) matrix = by * matrix;
}

template <class Real>
Real safe_inverse(const Real& x) {
    return 1 / max(x, constant<Real>(1e-30));
}

template <std::size_t bands, class Real>
std::array<PlanarMueller<Real>, bands> reflection(const PreparedMaterial& material, const Real& cos_theta) {
    std::array<PlanarMueller<Real>, bands> matrices;
    for (std::size_t band = 0; band < bands; ++band) {
        if (band > 0 && material.achromatic)
            matrices[band] = matrices[0];
        else if (material.interface == InterfaceKind::conductor)
            matrices[band] =
                planar(conductor_interface(cos_theta, Real(material.n[band]), Real(material.k[band])).reflection);
        else
            matrices[band] = planar(dielectric_interface(cos_theta, Real(material.n[band])).reflection);
    }
    return matrices;
}

/// What leaves the base on one side for what enters it on the other, f, 1/sr, in the s frames of the surface.
template <std::size_t bands, class Real>
std::array<PlanarMueller<Real>, bands> base_value(const PreparedMaterial& material, const Real& cos_in,
                                                  const Real& cos_out) {
    std::array<PlanarMueller<Real>, bands> matrices;
    for (std::size_t band = 0; band < bands; ++band)
        matrices[band] = Real(material.base_factor[band]) *
                         depolarized(material.passage(band, cos_out), material.passage(band, cos_in));
    return matrices;
}

/// The probability of going on by the base where the interface lets it choose: 1 - E under a rough one, in proportion
/// to what both send back at a smooth one.
template <std::size_t bands, class Real>
Real base_probability(const PreparedMaterial& material, const Real& cos_towards) {
    if (!material.reflects()) return Real(1);
    Real passed(0), returned(0), reflected(0);
    for (std::size_t band = 0; band < bands; ++band) {
        const Real through = material.passage(band, cos_towards).unpolarized;
        passed = passed + through;
        returned = fma(through, Real(material.base_survival[band]), returned);
        reflected = reflected + (1 - through);
    }
    if (material.rough()) return passed * constant<Real>(1.0 / static_cast<double>(bands));
    return returned * safe_inverse(returned + reflected);
}

/// Fills in a sharp or rough reflection without any choice: weight f cos / pdf.
template <FacetDraw draw, std::size_t bands, class Real>
ScatterSample<Real, bands> sample_interface(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                            const PlaneOfIncidence<Real>& plane, const ScatterNumbers<Real>& numbers) {
    ScatterSample<Real, bands> sample;
    const Vector<Real> arriving = -at.towards;
    const Real cos_towards = plane.cos_theta_i;
    sample.base = sample.refracted = cos_towards < Real(-1);
    if (material.finish == Finish::smooth) {
        sample.direction = reflected(arriving, at.normal);
        sample.axis = plane.axis;
        sample.turn = plane.turn;
        sample.weight = reflection<bands>(material, cos_towards);
        sample.pdf = Real(0);
        sample.alive = sample.sharp = cos_towards > Real(-1);
        return sample;
    }
    Real slope(material.slope);
    MaskOf<Real> mirror = cos_towards < Real(-1);
    if (material.finish == Finish::kirchhoff) {
        const Real drawn =
            sample_slope(material.rules(), material.kirchhoff<Real, bands>(), cos_towards, numbers.slope);
        mirror = !(drawn > 0);
        slope = select(mirror, Real(1), drawn);
    }
    const Real h = cotangent_over_slope(cos_towards, slope);
    FacetSlopes<Real> slopes;
    if constexpr (draw == FacetDraw::smooth)
        slopes = inverted_visible_slopes(h, numbers.facet_u, numbers.facet_v);
    else
        slopes = sample_visible_slopes(h, numbers.facet_u, numbers.facet_v, numbers.facet_w);
    const FacetReflection<Real> met = reflection_at(arriving, at.normal, plane, slope, slopes);
    const PlaneOfIncidence<Real> facet_plane = plane_of_incidence(arriving, at.carried_axis, met.facet);
    sample.sharp = mirror;
    sample.direction = select(mirror, reflected(arriving, at.normal), met.direction);
    sample.axis = select(mirror, plane.axis, facet_plane.axis);
    sample.turn = {select(mirror, plane.turn.cos_2t, facet_plane.turn.cos_2t),
                   select(mirror, plane.turn.sin_2t, facet_plane.turn.sin_2t)};
    const Real cos_r = dot(sample.direction, at.normal);
    sample.alive = cos_r > constant<Real>(1e-6);
    sample.weight = reflection<bands>(material, select(mirror, cos_towards, facet_plane.cos_theta_i));
    if (material.finish == Finish::beckmann) {
        const Real cos_h = max(min(dot(met.facet, at.normal), Real(1)), constant<Real>(1e-6));
        const Real seen = smith_g1(cotangent_over_slope(cos_towards, slope));
        sample.pdf = select(sample.alive, beckmann_d(cos_h, slope) * seen * safe_inverse(4 * cos_towards), Real(0));
        const Real safe_r = select(sample.alive, min(cos_r, Real(1)), Real(1));
        scale(sample.weight, select(sample.alive, smith_g1(cotangent_over_slope(safe_r, slope)), Real(0)));
    } else {
        const KirchhoffSurface<Real, bands> surface = material.kirchhoff<Real, bands>();
        const PoissonLobe<Real, bands> lobe =
            poisson_lobe(material.rules(), at.towards, sample.direction, at.normal, surface);
        const std::array<Real, bands> share = mirror_share(surface, cos_towards);
        const Real of_share = safe_inverse(band_mean(share)), of_pdf = safe_inverse(lobe.pdf_i);
        for (std::size_t band = 0; band < bands; ++band) {
            const Real rough = lobe.value[band] * cos_r * of_pdf;
            sample.weight[band] =
                select(mirror, share[band] * of_share, select(sample.alive, rough, Real(0))) * sample.weight[band];
        }
        sample.pdf = select(mirror, Real(0), lobe.pdf_i);
        sample.alive = sample.alive && (mirror || lobe.pdf_i > constant<Real>(1e-30));
    }
    return sample;
}

/// What a smooth transparent skin or pane does with light, whole.
template <class Real>
struct PartedLight {
    PlanarMueller<Real> mirrored, through;
    Vector<Real> onwards;  ///< unit, of what goes through
};

template <Use use, class Real>
PartedLight<Real> part_light(const PreparedMaterial& material, const SurfacePoint<Real>& at, const Real& cos_towards) {
    const Vector<Real> arriving = -at.towards;
    const Real n(material.refracting_n);
    if (material.thin) {
        const ThinPane<Real> pane = thin_pane(cos_towards, n);
        return {pane.reflection, pane.transmission, arriving};
    }
    const Real eta = at.inside ? 1 / n : n, inverse = 1 / eta;
    const DielectricInterface<Real> skin = dielectric_interface(cos_towards, eta);
    PlanarMueller<Real> through = planar(skin.transmission);
    // Radiance is compressed with the beam: (n_eye/n_light)^2, the eye being on the side of `towards`.
    if (use == Use::eye) through = (1 / (eta * eta)) * through;
    return {planar(skin.reflection), through,
            unit_again(add_scaled(inverse, arriving, (inverse * cos_towards - skin.cos_theta_t) * at.normal))};
}

/// One way on from there, by the mask `mirror` reflected, else refracted.
template <std::size_t bands, class Real>
ScatterSample<Real, bands> way_on(const PartedLight<Real>& parted, const SurfacePoint<Real>& at,
                                  const PlaneOfIncidence<Real>& plane, const MaskOf<Real>& mirror,
                                  const PlanarMueller<Real>& weight) {
    ScatterSample<Real, bands> sample;
    sample.direction = select(mirror, reflected(-at.towards, at.normal), parted.onwards);
    sample.axis = plane.axis;
    sample.turn = plane.turn;
    sample.weight.fill(weight);
    sample.pdf = Real(0);
    sample.alive = sample.sharp = plane.cos_theta_i > Real(-1);
    sample.refracted = !mirror;
    sample.base = plane.cos_theta_i < Real(-1);
    return sample;
}

/// Reflection or refraction, each chosen with its unpolarized power.
template <Use use, std::size_t bands, class Real>
ScatterSample<Real, bands> sample_transparent(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                              const PlaneOfIncidence<Real>& plane,
                                              const ScatterNumbers<Real>& numbers) {
    const PartedLight<Real> parted = part_light<use>(material, at, plane.cos_theta_i);
    const Real p = parted.mirrored.m00;
    const auto mirror = numbers.choice < p;
    return way_on<bands>(parted, at, plane, mirror,
                         select(mirror, safe_inverse(p) * parted.mirrored, safe_inverse(1 - p) * parted.through));
}

/// A polarizer or retarder sheet: light goes straight on. Its axis is that of the sheet less its part along the light,
/// and its matrix the same for light from either side (theory 1.3). Of unpolarized light a polarizer passes half.
template <std::size_t bands, class Real>
ScatterSample<Real, bands> sample_filter(const PreparedMaterial& material, const SurfacePoint<Real>& at) {
    ScatterSample<Real, bands> sample;
    const Vector<Real> onwards = -at.towards;
    sample.direction = onwards;
    sample.axis = axis_across(onwards, cross(at.filter_axis, onwards));  // d x (a x d) = a - (a.d) d
    sample.turn = rotation_between(onwards, at.carried_axis, sample.axis);
    const Real half = constant<Real>(0.5), none(0), one(1);
    for (std::size_t band = 0; band < bands; ++band) {
        const SineCosine<double>& shift = material.retardance[band];
        sample.weight[band] =
            material.filter == FilterKind::polarizer
                ? PlanarMueller<Real>{half, half, half, half, none, none}
                : PlanarMueller<Real>{one, none, none, one, constant<Real>(shift.cosine), constant<Real>(-shift.sine)};
    }
    sample.pdf = none;
    sample.alive = sample.sharp = sample.refracted = dot(at.towards, at.normal) > Real(-2);
    sample.base = dot(at.towards, at.normal) < Real(-2);
    return sample;
}

}  // namespace bsdf_detail

/// Whether sample_bsdf starts from sample_gloss.
inline bool has_gloss(const PreparedMaterial& material) {
    return material.reflects() && material.base != Base::transparent && material.filter == FilterKind::none;
}

/// The interface's own reflection, gloss or mirror, without any choice: weight f cos / pdf, at most 1 (bands of a
/// Kirchhoff surface: 3). Not for transparent materials; dead without an interface.
template <std::size_t bands, FacetDraw draw = FacetDraw::quick, class Real>
ScatterSample<Real, bands> sample_gloss(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                        const ScatterNumbers<Real>& numbers) {
    const PlaneOfIncidence<Real> plane = plane_of_incidence(-at.towards, at.carried_axis, at.normal);
    ScatterSample<Real, bands> sample = bsdf_detail::sample_interface<draw, bands>(material, at, plane, numbers);
    sample.alive = sample.alive && dot(at.towards, at.normal) > constant<Real>(1e-6);
    if (!material.reflects()) sample.alive = plane.cos_theta_i < Real(-1);
    return sample;
}

/// A direction above a surface, by the cosine, and the s axis that the surface gives it.
template <class Real>
struct CosineDirection {
    Vector<Real> direction, axis;
    Real cosine;  ///< density: over pi, 1/sr
};

/// From two uniform numbers in [0, 1). `side`: unit, orthogonal to the normal.
template <class Real>
CosineDirection<Real> sample_cosine(const Vector<Real>& normal, const Vector<Real>& side, const Real& u,
                                    const Real& v) {
    const Real radius = sqrt(u), cosine = sqrt(1 - u);
    const SineCosine<Real> azimuth = sincos_turns(v);
    // The side, the normal's cross product with it, and the normal are a right-handed frame.
    const Vector<Real> across = cross(normal, side);
    const Vector<Real> around = add_scaled(azimuth.cosine, side, azimuth.sine * across);
    return {unit_again(add_scaled(radius, around, cosine * normal)),
            add_scaled(azimuth.sine, side, -azimuth.cosine * across), cosine};
}

/// An exit from, or for the eye an entry into, the base: cosine-distributed, weight f cos / pdf. `plane`: of incidence of
/// the known direction.
template <Use use, std::size_t bands, class Real>
ScatterSample<Real, bands> sample_base(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                       const PlaneOfIncidence<Real>& plane, const ScatterNumbers<Real>& numbers) {
    using namespace bsdf_detail;
    const auto drawn = sample_cosine(at.normal, plane.axis, numbers.exit_u, numbers.exit_v);
    ScatterSample<Real, bands> sample;
    sample.direction = drawn.direction;
    sample.axis = drawn.axis;
    sample.turn = plane.turn;
    sample.weight = use == Use::light ? base_value<bands>(material, plane.cos_theta_i, drawn.cosine)
                                      : base_value<bands>(material, drawn.cosine, plane.cos_theta_i);
    scale(sample.weight, constant<Real>(pi));
    sample.pdf = drawn.cosine * constant<Real>(1 / pi);
    sample.base = sample.alive = plane.cos_theta_i > Real(-1);
    sample.sharp = sample.refracted = plane.cos_theta_i < Real(-1);
    return sample;
}

/// One way on, chosen among all lobes by their unpolarized power (the only way of a material that has just one is taken
/// without a choice; absorption is in the weight). From the same numbers the same bits, whatever the light's state.
/// `gloss`: sample_gloss of the same numbers, which is looked at only where has_gloss(material).
template <Use use, std::size_t bands, class Real>
ScatterSample<Real, bands> sample_bsdf(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                       const ScatterNumbers<Real>& numbers, const ScatterSample<Real, bands>& gloss) {
    using namespace bsdf_detail;
    const PlaneOfIncidence<Real> plane = plane_of_incidence(-at.towards, at.carried_axis, at.normal);
    const auto above = dot(at.towards, at.normal) > constant<Real>(1e-6);
    ScatterSample<Real, bands> sample;
    if (material.filter != FilterKind::none) {
        sample = sample_filter<bands>(material, at);
    } else if (material.base == Base::transparent) {
        sample = sample_transparent<use, bands>(material, at, plane, numbers);
    } else if (!material.reflects()) {
        sample = sample_base<use, bands>(material, at, plane, numbers);
        if (!material.diffuse()) sample.alive = !above && above;
    } else if (!material.diffuse()) {
        sample = gloss;
    } else {
        const Real of_base = base_probability<bands>(material, plane.cos_theta_i);
        // Under a rough interface the facet is known before the choice, and 1 - p is 1 - E on average.
        const Real p = material.rough() ? select(gloss.alive, band_mean(gloss.weight), Real(0)) : 1 - of_base;
        const auto mirror = numbers.choice < p;
        ScatterSample<Real, bands> chosen = gloss;
        scale(chosen.weight, safe_inverse(p));
        chosen.pdf = gloss.pdf * p;
        if (!any_of(!mirror)) {
            sample = chosen;
        } else {
            ScatterSample<Real, bands> base = sample_base<use, bands>(material, at, plane, numbers);
            scale(base.weight, safe_inverse(of_base));
            base.pdf = base.pdf * of_base;
            sample = select_sample<bands, Real>(mirror, chosen, base);
        }
    }
    sample.alive = sample.alive && above;
    return sample;
}
template <Use use, std::size_t bands, class Real>
ScatterSample<Real, bands> sample_bsdf(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                                       const ScatterNumbers<Real>& numbers) {
    ScatterSample<Real, bands> gloss;
    if (has_gloss(material)) gloss = sample_gloss<bands>(material, at, numbers);
    return sample_bsdf<use, bands>(material, at, numbers, gloss);
}

/// Both ways on at a transparent material, without any choice: what it reflects, then what it lets through.
template <Use use, std::size_t bands, class Real>
std::array<ScatterSample<Real, bands>, 2> both_ways(const PreparedMaterial& material, const SurfacePoint<Real>& at) {
    using namespace bsdf_detail;
    const PlaneOfIncidence<Real> plane = plane_of_incidence(-at.towards, at.carried_axis, at.normal);
    const auto above = dot(at.towards, at.normal) > constant<Real>(1e-6);
    const PartedLight<Real> parted = part_light<use>(material, at, plane.cos_theta_i);
    const MaskOf<Real> all = plane.cos_theta_i > Real(-1), none = plane.cos_theta_i < Real(-1);
    std::array<ScatterSample<Real, bands>, 2> ways = {way_on<bands>(parted, at, plane, all, parted.mirrored),
                                                      way_on<bands>(parted, at, plane, none, parted.through)};
    for (ScatterSample<Real, bands>& way : ways) way.alive = way.alive && above;
    return ways;
}

/// A lobe between two given directions.
template <class Real, std::size_t bands>
struct LobeValue {
    std::array<PlanarMueller<Real>, bands> value;  ///< f, 1/sr, in light order; without the cosine
    Vector<Real> axis_in, axis_out;                ///< s axes of the light that comes and of that which leaves
    Real pdf;  ///< density with which sample_bsdf (of evaluate_gloss: sample_gloss) takes this lobe into the direction
               ///< it samples, 1/sr
};

template <class Real, std::size_t bands>
struct BsdfValue {
    LobeValue<Real, bands> gloss, base;
    bool has_gloss = false, has_base = false;  ///< the others are not filled in
};

/// A rough interface's gloss between light arriving along `light_in` and leaving along `light_out` (unit, both as the
/// light travels): zero where either is not above the surface. `use`: whose direction is known; the density is that of
/// sample_gloss, without any choice.
template <Use use, std::size_t bands, class Real>
LobeValue<Real, bands> evaluate_gloss(const PreparedMaterial& material, const Vector<Real>& light_in,
                                      const Vector<Real>& light_out, const Vector<Real>& normal) {
    using namespace bsdf_detail;
    LobeValue<Real, bands> gloss;
    const Vector<Real> i = -light_in, r = light_out;
    const auto above = dot(i, normal) > constant<Real>(1e-6) && dot(r, normal) > constant<Real>(1e-6);
    std::array<Real, bands> unit;
    Real cos_h;
    if (material.finish == Finish::beckmann) {
        const BeckmannLobe<Real> lobe = beckmann_lobe(i, r, normal, Real(material.slope));
        unit.fill(lobe.value);
        gloss.pdf = use == Use::light ? lobe.pdf_i : lobe.pdf_r;
        cos_h = lobe.cos_theta_h;
    } else {
        const PoissonLobe<Real, bands> lobe =
            poisson_lobe(material.rules(), i, r, normal, material.kirchhoff<Real, bands>());
        unit = lobe.value;
        gloss.pdf = use == Use::light ? lobe.pdf_i : lobe.pdf_r;
        cos_h = lobe.cos_theta_h;
    }
    gloss.value = reflection<bands>(material, min(cos_h, Real(1)));
    for (std::size_t band = 0; band < bands; ++band)
        gloss.value[band] = select(above, unit[band], Real(0)) * gloss.value[band];
    gloss.pdf = select(above, gloss.pdf, Real(0));
    gloss.axis_in = axis_across(light_in, light_out);
    gloss.axis_out = axis_across(light_out, light_in);
    return gloss;
}

/// The same of the base.
template <Use use, std::size_t bands, class Real>
LobeValue<Real, bands> evaluate_base(const PreparedMaterial& material, const Vector<Real>& light_in,
                                     const Vector<Real>& light_out, const Vector<Real>& normal) {
    using namespace bsdf_detail;
    LobeValue<Real, bands> base;
    const Real cos_i = dot(-light_in, normal), cos_r = dot(light_out, normal);
    const auto above = cos_i > constant<Real>(1e-6) && cos_r > constant<Real>(1e-6);
    const Real safe_i = select(above, min(cos_i, Real(1)), Real(1));
    const Real safe_r = select(above, min(cos_r, Real(1)), Real(1));
    const Real known = use == Use::light ? safe_i : safe_r, sampled = use == Use::light ? safe_r : safe_i;
    base.value = base_value<bands>(material, safe_i, safe_r);
    scale(base.value, select(above, Real(1), Real(0)));
    base.pdf = select(above, base_probability<bands>(material, known) * sampled * constant<Real>(1 / pi), Real(0));
    base.axis_in = axis_across(light_in, normal);
    base.axis_out = axis_across(light_out, normal);
    return base;
}

/// Everything that can be evaluated between light arriving along `light_in` and leaving along `light_out` (unit, both
/// as the light travels): sharp lobes, having no value, are left out. Zero where either is not above the surface.
/// `use`: whose direction is known; the densities are those of sampling the other one.
template <Use use, std::size_t bands, class Real>
BsdfValue<Real, bands> evaluate_bsdf(const PreparedMaterial& material, const Vector<Real>& light_in,
                                     const Vector<Real>& light_out, const Vector<Real>& normal) {
    BsdfValue<Real, bands> result;
    result.has_gloss = material.rough();
    if (result.has_gloss) {
        result.gloss = evaluate_gloss<use, bands>(material, light_in, light_out, normal);
        if (material.diffuse()) {
            // Of sample_bsdf, which takes the facet it has drawn with the probability of its weight.
            const Real sampled = use == Use::light ? dot(light_out, normal) : dot(-light_in, normal);
            const auto above = result.gloss.pdf > 0;
            result.gloss.pdf =
                select(above, bsdf_detail::band_mean(result.gloss.value) * min(sampled, Real(1)), Real(0));
        }
    }
    result.has_base = material.diffuse();
    if (result.has_base) result.base = evaluate_base<use, bands>(material, light_in, light_out, normal);
    return result;
}

}  // namespace brewster
