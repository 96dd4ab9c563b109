#pragma once
#include "base/elementary.h"
#include "base/word_lanes.h"
#include "optics/vector.h"

/// Directions that light leaves its lamps in, from two numbers in [0, 1): for one photon or a batch of lanes.
namespace brewster {

/// A direction against the middle of all that a lamp sends out.
template <class Real>
struct Slant {
    Real sine, cosine;
};

/// Cosine-distributed: density cos / pi.
template <class Real>
Slant<Real> cosine_slant(const Real& x) {
    return {sqrt(x), sqrt(1 - x)};
}

/// Uniform over the sphere.
template <class Real>
Slant<Real> sphere_slant(const Real& x) {
    return {2 * sqrt(x * (1 - x)), 1 - 2 * x};  // 1 - z z without cancellation at the poles
}

/// A sun's disc, by what each direction carries across the beam: density cos / (pi sin^2 radius).
template <class Real>
Slant<Real> disc_slant(const Real& sine_of_radius, const Real& x) {
    const Real sine = sine_of_radius * sqrt(x);
    return {sine, sqrt((1 - sine) * (1 + sine))};
}

/// x^(1/3) for x in [0, 1]: a third of the exponent, then Halley's steps, each tripling the digits.
template <class Real>
Real cube_root(const Real& x) {
    Real r = floats_of(third_of(words_of(x)) + Word<Real>(709921077u));
    for (int step = 0; step < 3; ++step) {
        const Real rrr = r * r * r;
        r = r * ((rrr + 2 * x) / (2 * rrr + x));
    }
    return select(x > 0, r, Real(0));
}

/// Integral of a spot's falloff over the cosine: between the cones, inside them.
template <class Real>
struct SpotShares {
    Real edge, core;
};

template <class Real>
SpotShares<Real> spot_shares(const Real& cos_inner, const Real& cos_outer) {
    return {(cos_inner - cos_outer) * constant<Real>(1.0 / 3), 1 - cos_inner};
}

/// A spot's falloff, by inverting its cubic integral, in 1 - cos, which stays exact in narrow cones. x runs from the axis
/// outwards.
template <class Real>
Slant<Real> spot_slant(const Real& cos_inner, const Real& cos_outer, const Real& x) {
    const SpotShares<Real> shares = spot_shares(cos_inner, cos_outer);
    const Real wanted = x * (shares.edge + shares.core);
    const auto beyond = wanted >= shares.core && shares.edge > 0;
    const Real left = max((shares.edge - (wanted - shares.core)) / select(beyond, shares.edge, Real(1)), Real(0));
    const Real versine = select(beyond, (1 - cos_inner) + (1 - cube_root(left)) * (cos_inner - cos_outer), wanted);
    return {sqrt(versine * (2 - versine)), 1 - versine};
}

/// The direction of a slant, turned about the last axis of a right-handed frame.
template <class Real>
Vector<Real> turned_about(const Vector<Real>& u, const Vector<Real>& v, const Vector<Real>& middle,
                          const Slant<Real>& slant, const Real& turns) {
    const SineCosine<Real> turn = sincos_turns(turns);
    return slant.sine * turn.cosine * u + slant.sine * turn.sine * v + slant.cosine * middle;
}

}  // namespace brewster
