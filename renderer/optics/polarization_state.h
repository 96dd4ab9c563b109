#pragma once
#include <cmath>

#include "base/units.h"
#include "optics/stokes.h"

/// What people read off a Stokes vector: angles and decompositions. Display and reports, not the photon loop.
namespace brewster {

/// Angle of linear polarization in (-pi/2, pi/2], counter-clockwise from the x axis seen by the receiver.
/// 0 where there is no linear polarization, where the angle means nothing.
template <int components>
double aolp(const Stokes<double, components>& light) {
    if (light.s1() == 0 && light.s2() == 0) return 0;
    const double angle = 0.5 * std::atan2(light.s2(), light.s1());
    return angle <= -0.5 * pi ? 0.5 * pi : angle;
}

/// The ellipse that the field's tip draws, for the polarized part of the light.
struct PolarizationEllipse {
    double semi_major, semi_minor;  ///< field amplitudes, in the square root of the unit of S0
    double orientation;             ///< of the major axis, as aolp
    double ellipticity;             ///< atan(semi_minor / semi_major) in [-pi/4, pi/4], positive: right-handed
};

/// Born and Wolf, Principles of Optics, 1.4.2: sin 2 chi = S3 / polarized intensity.
inline PolarizationEllipse polarization_ellipse(const Stokes<double, 4>& light) {
    const double polarized = std::hypot(light.s1(), light.s2(), light.s3());
    if (!(polarized > 0)) return {0, 0, 0, 0};
    const double linear = std::hypot(light.s1(), light.s2());
    const double ellipticity = 0.5 * std::atan2(light.s3(), linear);
    const double amplitude = std::sqrt(polarized);
    return {amplitude * std::cos(ellipticity), amplitude * std::abs(std::sin(ellipticity)), aolp(light), ellipticity};
}

/// Two beams that add up to a given one.
struct StokesPair {
    Stokes<double, 4> first, second;
};

/// First unpolarized, second completely polarized (thesis 2.31, with the weights on S0 alone).
inline StokesPair split_by_polarization(const Stokes<double, 4>& light) {
    const double polarized = polarized_intensity(light);
    return {{{light.s0() - polarized, 0, 0, 0}}, {{polarized, light.s1(), light.s2(), light.s3()}}};
}

/// Two completely polarized beams in antipodal states (thesis 2.32). For unpolarized light, where any pair will do,
/// the states are x and y linear.
inline StokesPair split_into_antipodes(const Stokes<double, 4>& light) {
    const double polarized = polarized_intensity(light);
    const Stokes<double, 4> state =
        polarized > 0 ? Stokes<double, 4>{{1, light.s1() / polarized, light.s2() / polarized, light.s3() / polarized}}
                      : Stokes<double, 4>{{1, 1, 0, 0}};
    const Stokes<double, 4> antipode{{1, -state.s1(), -state.s2(), -state.s3()}};
    return {(0.5 * (light.s0() + polarized)) * state, (0.5 * (light.s0() - polarized)) * antipode};
}

}  // namespace brewster
