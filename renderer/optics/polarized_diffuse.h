#pragma once
#include <cmath>

#include "base/elementary.h"
#include "base/units.h"
#include "optics/fresnel.h"

/// Matter under a dielectric interface: light refracts in, loses its polarization, is partly absorbed, meets the
/// interface from inside again and again, and refracts out. M = rho/(pi n^2 (1 - rho Fi)) T(o) diag(1,0,0,0) T(i).
namespace brewster {

/// What the interface lets through at an outside angle, in the s frame: unpolarized power, and s minus p (negative).
/// Entry row and exit column of the base alike.
template <class Real>
struct Passage {
    Real unpolarized, s_minus_p;
};

/// A smooth interface of index n = n_t/n_i seen from outside.
template <class Real>
Passage<Real> smooth_passage(const Real& cos_theta, const Real& n) {
    const InterfaceMueller<Real> through = dielectric_interface(cos_theta, n).transmission;
    return {through.a, through.b};
}

/// The power that enters the base, from light in the s frame of its mean surface.
template <class Real, int components>
Real entered_power(const Passage<Real>& in, const Stokes<Real, components>& light) {
    return fma(in.unpolarized, light.s0(), in.s_minus_p * light.s1());
}

/// Internal diffuse reflectance from the external one: the same interface from inside.
template <class Real>
Real internal_reflectance(const Real& external, const Real& n) {
    return 1 - (1 - external) / (n * n);
}

/// What the base sends back into the interface of all that entered: rho/(pi n^2 (1 - rho Fi)) of the power, per
/// projected solid angle outside. rho: albedo of the base per inner bounce.
template <class Real>
Real base_radiance_factor(const Real& rho, const Real& n, const Real& internal) {
    return rho * constant<Real>(1 / pi) / (n * n * (1 - rho * internal));
}

/// Stokes radiance that leaves at the outside angle of `out`, in the s frame of the exit, for `entered` power a unit
/// area.
template <int components, class Real>
Stokes<Real, components> base_radiance(const Passage<Real>& out, const Real& entered, const Real& factor) {
    const Real scale = entered * factor;
    return stokes_of<components>(out.unpolarized * scale, out.s_minus_p * scale, Real(0), Real(0));
}

/// Share of the entered power that leaves: rho (1 - Fi)/(1 - rho Fi); 1 for rho = 1.
template <class Real>
Real base_survival(const Real& rho, const Real& internal) {
    return rho * (1 - internal) / (1 - rho * internal);
}

/// Weight of a cosine-distributed exit after `base_survival`: T(o)/(1 - Fe), the ratio of the exit's density
/// T(o) cos/(pi (1 - Fe)) to the cosine's. Mean 1.
template <class Real>
Real exit_weight(const Passage<Real>& out, const Real& external) {
    return out.unpolarized / (1 - external);
}

/// A cosine-distributed direction about z from two uniform numbers in [0, 1): density cos/pi.
template <class Real>
Vector<Real> sample_cosine(const Real& u0, const Real& u1) {
    const Real radius = sqrt(u0);
    const SineCosine<Real> turn = sincos_turns(u1);
    return {radius * turn.cosine, radius * turn.sine, sqrt(1 - u0)};
}

/// External diffuse reflectance Fe of a smooth interface for unpolarized light, n >= 1: Walsh's closed form (1926,
/// Duntley 1942), by quadrature below n = 1.01 where it cancels.
double external_reflectance(double n);

}  // namespace brewster
