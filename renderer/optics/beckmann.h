#pragma once
#include "base/units.h"
#include "optics/frame.h"
#include "optics/shadowing.h"

/// Rough interfaces as facets with Gaussian slopes, Beckmann slope m = 2 sigma / tau (thesis 6.58): model V.
namespace brewster {

/// D(h) = exp(-tan^2/m^2)/(pi m^2 cos^4): facet area per surface area and solid angle, 1/sr. cos_delta = h.N in [0, 1].
template <class Real>
Real beckmann_d(const Real& cos_delta, const Real& m) {
    const Real c2 = max(cos_delta * cos_delta, constant<Real>(1e-12));
    const Real inv_m2 = 1 / (m * m);
    const Real tan2 = max(1 - c2, Real(0)) / c2;
    return exp(-tan2 * inv_m2) * inv_m2 * constant<Real>(1 / pi) / (c2 * c2);
}

/// Slopes of a facet over m: along the plane of incidence (positive leans towards the source) and across it.
template <class Real>
struct FacetSlopes {
    Real along, across;
};

/// Draws the facet that a ray with h = cot(theta)/m meets first: density proportional to (1 + x/h) exp(-x^2 - y^2) on
/// x > -h (visible normals, Heitz and d'Eon 2014), from three uniform numbers in [0, 1). Exact, without inversion:
/// for |x| < h the pair +-x has the mass of the plain Gaussian, so a Gaussian draw only needs its sign chosen with
/// P(+) = (1 + |x|/h)/2; what the Gaussian puts at x < -h, and the excess Lambda of the total mass 1 + Lambda, goes to
/// the rest of the tail, x exp(-x^2) on x > h, whose inverse is x^2 = h^2 - ln u.
template <class Real>
[[gnu::always_inline]] inline FacetSlopes<Real> sample_visible_slopes(const Real& h, const Real& u0, const Real& u1,
                                                                      const Real& u2) {
    const Real g1 = smith_g1(h);
    const Real tail = 1 - g1;  // Lambda / (1 + Lambda)
    const auto in_excess = u2 < tail;
    const Real rest =
        select(in_excess, u2 / max(tail, constant<Real>(1e-30)), (u2 - tail) / max(g1, constant<Real>(1e-30)));

    const Real radius = sqrt(-log(1 - u0));
    const SineCosine<Real> turn = sincos_turns(u1);
    const Real x = radius * turn.cosine;
    const auto in_tail = in_excess || x < -h;
    const Real positive = fma(Real(2) * rest, h, -h);  // |x| > this with probability (1 + |x|/h)/2
    const Real magnitude = abs(x);
    const Real chosen = select(magnitude > positive, magnitude, -magnitude);
    const Real gaussian = select(magnitude < h, chosen, magnitude);
    const Real bounded = min(h, constant<Real>(1e9));
    const Real excess = sqrt(fma(bounded, bounded, -log(1 - min(rest, constant<Real>(0.99999994)))));
    return {select(in_tail, excess, gaussian), radius * turn.sine};
}

/// A facet met by a photon and the direction it reflects into.
template <class Real>
struct FacetReflection {
    Vector<Real> facet;      ///< its normal, towards the photon's side
    Vector<Real> direction;  ///< of the reflected light
    Real cos_r;              ///< its cosine against the mean normal; absorbed where <= 0
};

/// Reflects a photon going along `direction` at the facet of these slopes over m.
template <class Real>
[[gnu::always_inline]] inline FacetReflection<Real> reflection_at(const Vector<Real>& direction,
                                                                  const Vector<Real>& normal,
                                                                  const PlaneOfIncidence<Real>& plane, const Real& m,
                                                                  const FacetSlopes<Real>& slopes) {
    // Towards the source is s x N, across is s itself.
    const Vector<Real> towards = cross(plane.axis, normal);
    const Vector<Real> facet =
        normalized(add_scaled(m * slopes.along, towards, add_scaled(m * slopes.across, plane.axis, normal)));
    const Vector<Real> out = reflected(direction, facet);
    return {facet, out, dot(out, normal)};
}

/// Draws a facet for a photon going along `plane`'s direction k that meets the mean surface `normal` with cosine
/// plane.cos_theta_i: facet density G1(i) D (i.h)/cos_i, direction density G1(i) D/(4 cos_i).
template <class Real>
[[gnu::always_inline]] inline FacetReflection<Real> sample_facet(const Vector<Real>& direction,
                                                                 const Vector<Real>& normal,
                                                                 const PlaneOfIncidence<Real>& plane, const Real& m,
                                                                 const Real& u0, const Real& u1, const Real& u2) {
    const Real h = cotangent_over_slope(plane.cos_theta_i, m);
    return reflection_at(direction, normal, plane, m, sample_visible_slopes(h, u0, u1, u2));
}

/// Everything model V needs of a pair of directions.
template <class Real>
struct BeckmannLobe {
    Real value;        ///< BRDF for F = 1: D G1(i) G1(r)/(4 cos_i cos_r), 1/sr; reciprocal
    Real pdf_i;        ///< density of r when i is sampled from: G1(i) D/(4 cos_i)
    Real pdf_r;        ///< density of i when r is sampled from: G1(r) D/(4 cos_r)
    Real cos_theta_h;  ///< i.h = r.h, the angle at the facet
};

/// i and r are unit vectors away from the surface, cos_i = i.N and cos_r = r.N; all zero where either is not above it.
template <class Real>
BeckmannLobe<Real> beckmann_lobe(const Vector<Real>& i, const Vector<Real>& r, const Vector<Real>& normal,
                                 const Real& m) {
    const Real cos_i = dot(i, normal), cos_r = dot(r, normal);
    const auto above = cos_i > 0 && cos_r > 0;
    const Real safe_i = select(above, min(cos_i, Real(1)), Real(1)),
               safe_r = select(above, min(cos_r, Real(1)), Real(1));
    const Vector<Real> sum = i + r;
    const Real length = sqrt(max(dot(sum, sum), constant<Real>(1e-30)));
    const Real cos_delta = min((safe_i + safe_r) / length, Real(1));
    const Real d = select(above, constant<Real>(0.25) * beckmann_d(cos_delta, m), Real(0));
    const Real g_i = smith_g1(cotangent_over_slope(safe_i, m)), g_r = smith_g1(cotangent_over_slope(safe_r, m));
    return {d * (g_i / safe_i) * (g_r / safe_r), d * (g_i / safe_i), d * (g_r / safe_r), constant<Real>(0.5) * length};
}

}  // namespace brewster
