#pragma once
#include "optics/beckmann.h"

/// Visible normals from two numbers, for sequences whose points lie more evenly than random ones: near numbers give near
/// facets. (sample_visible_slopes is cheaper, but its third number turns facets over.)
namespace brewster {

/// x with erfc(x)/2 = u, absolute error below .005, for 0 < u < 1 (Winitzki's closed form of the error function).
template <class Real>
Real roughly_inverted_erfc(const Real& u) {
    constexpr double a = 0.147;
    const Real l = log(max(4 * u * (1 - u), constant<Real>(1e-12)));
    const Real t = fma(l, constant<Real>(0.5), constant<Real>(2 / (pi * a)));
    const Real x = sqrt(max(sqrt(max(fma(t, t, l * constant<Real>(-1 / a)), Real(0))) - t, Real(0)));
    return select(u > constant<Real>(0.5), -x, x);
}

/// x with erfc(x)/2 = u: one step of Halley's method more. Error of erfc(x)/2 below 1e-6.
template <class Real>
Real inverted_erfc(const Real& u) {
    const Real x = roughly_inverted_erfc(u);
    const Real step = (u - constant<Real>(0.5) * erfc(x)) * constant<Real>(1.7724538509055160) * exp(x * x);
    return x - step / fma(x, step, Real(1));
}

/// The slope along the plane of incidence of a facet that is met, over m: x with the share u of the density
/// (1 + x/h) exp(-x^2) on x > -h above it. 0 < u < 1; error of the share below 2e-5, by measurement.
/// A first guess, then two steps of Newton's method for ln((1 - Q)/Q) as a function of ln(x + h), in which it is all but
/// straight. Guesses: Rayleigh's distribution with a term of h where h is small; else a Gaussian of the same mean and
/// variance, or the parabola that the share begins with at -h.
template <class Real>
Real inverted_slope(const Real& h, const Real& u) {
    const Real lambda = smith_lambda_times_h(h), scale = 1 / (h + lambda);
    const Real log_u = log(u), radius = sqrt(-log_u);

    const Real bend = constant<Real>(0.886) / fma(constant<Real>(0.5), radius, Real(1));
    const Real rayleigh = fma(radius, fma(h, bend, Real(1)), -h);
    const Real inverse = 1 / max(h, Real(1)), shift = constant<Real>(0.5) * inverse;
    const Real gaussian = fma(roughly_inverted_erfc(u), sqrt(fma(-shift, inverse, Real(1))), shift);
    const Real near = min(h, constant<Real>(3.2));
    const Real root = radius * sqrt(constant<Real>(3.5449077018110320) * exp(near * near) * (near + lambda));
    const Real parabola = root / sqrt(fma(near * root, constant<Real>(4.0 / 3), Real(1))) - near;
    const auto at_end = gaussian < constant<Real>(-0.6) * h && h < constant<Real>(3.2);
    Real x = max(select(h < Real(1), rayleigh, select(at_end, parabola, gaussian)), -h);

    const Real wanted = log(max(1 - u, constant<Real>(1e-7))) - log_u;
    for (int step = 0; step < 2; ++step) {
        const Real e = exp(-x * x) * constant<Real>(0.28209479177387814);  // over 2 sqrt(pi)
        const Real above = max(scale * fma(constant<Real>(0.5) * h, erfc(x), e), constant<Real>(1e-12));
        const Real below = max(1 - above, constant<Real>(1e-7));
        const Real reach = h + x, density = max(2 * scale * reach * e, constant<Real>(1e-30));
        const Real change = (wanted - log(below / above)) * below * above / density;  // of x, were it straight in x
        const Real relative = max(min(change / max(reach, constant<Real>(1e-30)), Real(1)), Real(-1));
        x = fma(reach, relative * fma(relative, constant<Real>(0.5), Real(1)), x);
        x = max(min(x, constant<Real>(5.5)), -h);
    }
    return x;
}

/// Two uniform numbers in [0, 1).
template <class Real>
[[gnu::always_inline]] inline FacetSlopes<Real> inverted_visible_slopes(const Real& h, const Real& u0, const Real& u1) {
    const auto inside = [](const Real& u) { return max(u, constant<Real>(0x1p-25)); };
    return {inverted_slope(h, inside(u0)), inverted_erfc(inside(u1))};
}

}  // namespace brewster
