#pragma once
#include "optics/beckmann.h"

/// The thesis's own way to draw a reflected direction (chapter 7, equations 7.39 to 7.53), kept to compare with. It is
/// biased: it drops the weight 1 + tan(delta) tan(theta_i) cos(phi) of 7.39, and it does not thin out those delta whose
/// azimuths the horizon cuts. With acceptance S F, energy and directions are off by tens of per cent for m tan(theta_i)
/// near 1; the engine draws visible normals instead (beckmann.h).
namespace brewster {

/// Limits that keep the reflected ray above the horizon.
template <class Real>
struct ThesisLimits {
    Real reach;      ///< 1 - exp(-tan^2(delta_max)/m^2): the share of the Gaussian within tan(delta_max) (7.48, 7.50)
    Real full_turn;  ///< tan(delta) up to which every azimuth is allowed: cos/(1 + sin) (7.51, 7.52)
};

/// cos_theta_i in (0, 1].
template <class Real>
ThesisLimits<Real> thesis_limits(const Real& cos_theta_i, const Real& m) {
    const Real up = 1 + sqrt((1 - cos_theta_i) * (1 + cos_theta_i));
    const Real tan_max = up / max(cos_theta_i, constant<Real>(1e-9));
    const Real exponent = (tan_max / m) * (tan_max / m);
    return {one_minus_exp(min(exponent, Real(80))), cos_theta_i / up};
}

/// Largest azimuth that leaves the ray above the horizon: pi, or acos(-cot(theta_i) cot(2 delta)) (7.51, 7.53).
template <class Real>
Real thesis_azimuth_limit(const Real& cos_theta_i, const Real& tan_delta, const ThesisLimits<Real>& limits) {
    const Real sin_theta = sqrt((1 - cos_theta_i) * (1 + cos_theta_i));
    const Real cot_2delta = constant<Real>(0.5) * (1 - tan_delta * tan_delta) / max(tan_delta, constant<Real>(1e-20));
    const Real argument = -cos_theta_i / max(sin_theta, constant<Real>(1e-9)) * cot_2delta;
    const Real limit = acos(max(min(argument, Real(1)), Real(-1)));
    return select(tan_delta <= limits.full_turn, constant<Real>(pi), limit);
}

/// Draws slopes over m in the frame of FacetSlopes from two uniform numbers in [0, 1): tan(delta) from the Gaussian cut
/// at delta_max, the azimuth evenly in what is allowed.
template <class Real>
FacetSlopes<Real> sample_thesis_slopes(const Real& cos_theta_i, const Real& m, const Real& u0, const Real& u1) {
    const ThesisLimits<Real> limits = thesis_limits(cos_theta_i, m);
    const Real radius = sqrt(-log(max(fma(-limits.reach, u0, Real(1)), constant<Real>(1e-37))));
    const Real limit = thesis_azimuth_limit(cos_theta_i, m * radius, limits);
    // (2 u - 1) limit as a fraction of a turn in [0, 1).
    const Real turns = (2 * u1 - 1) * limit * constant<Real>(0.5 / pi);
    const SineCosine<Real> turn = sincos_turns(select(turns < 0, turns + 1, turns));
    return {radius * turn.cosine, radius * turn.sine};
}

/// Density per solid angle of r for this sampler; i and r unit, away from the surface z = 0.
template <class Real>
Real thesis_pdf(const Vector<Real>& i, const Vector<Real>& r, const Real& m) {
    const Vector<Real> h = normalized(i + r);
    const Real cos_delta = max(h.z, constant<Real>(1e-6));
    const Real tan_delta = sqrt(max((1 - cos_delta) * (1 + cos_delta), Real(0))) / cos_delta;
    const ThesisLimits<Real> limits = thesis_limits(i.z, m);
    const Real limit = max(thesis_azimuth_limit(i.z, tan_delta, limits), constant<Real>(1e-6));
    const Real density = beckmann_d(cos_delta, m) * cos_delta * constant<Real>(pi) / (limits.reach * limit);
    return select(r.z > 0, density / (4 * dot(i, h)), Real(0));
}

}  // namespace brewster
