#pragma once
#include <type_traits>

#include <numbers>

#include "base/elementary.h"

/// Shadowing of a Gaussian surface (Smith 1967), seen from a direction theta through h = cot(theta) / m.
namespace brewster {

/// h = cot(theta)/m for cos_theta in [0, 1] and m > 0; at most 1e15, which stands for the normal direction.
template <class Real>
Real cotangent_over_slope(const Real& cos_theta, const Real& m) {
    const Real sin_theta = sqrt((1 - cos_theta) * (1 + cos_theta));
    return min(cos_theta / max(m * sin_theta, constant<Real>(1e-30)), constant<Real>(1e15));
}

/// h Lambda(h), finite at h = 0 (not for double).
template <class Real>
[[gnu::always_inline]] inline Real smith_lambda_times_h(const Real& h) {
    const Real bounded = min(h, Real(10));
    const Real rest = 1 - constant<Real>(1.7724538509055160) * bounded * erfcx(bounded);
    return exp(-bounded * bounded) * max(rest, Real(0)) * constant<Real>(0.28209479177387814);
}

/// Lambda(h) = (exp(-h^2)/(sqrt(pi) h) - erfc(h))/2: the shadowed facets' area over the seen one. The exponential is
/// missing in thesis 6.25 and in He et al. 1991 (25). Infinite at h = 0, zero above h = 26 (float: 9.3).
/// Double: relative error below 1e-10, of 1/(1 + Lambda) 1e-15. Float: absolute error of 1/(1 + Lambda) below 4e-7,
/// relative error of Lambda below 2e-6 up to h = 1 and below 6e-5 where it is a normal number.
template <class Real>
Real smith_lambda(const Real& h) {
    if constexpr (std::is_same_v<Real, double>) {
        return h > 26 ? 0 : 0.5 * (std::exp(-h * h) * std::numbers::inv_sqrtpi / h - std::erfc(h));
    } else {
        return smith_lambda_times_h(h) / h;
    }
}

/// G1 = 1/(1 + Lambda): the share of facets facing the ray that it reaches; 0 at grazing incidence, 1 at the normal.
/// What belongs with a facet that reflects i into r, for it faces both (Walter et al. 2007; Heitz 2014).
template <class Real>
[[gnu::always_inline]] inline Real smith_g1(const Real& h) {
    if constexpr (std::is_same_v<Real, double>)
        return 1 / (1 + smith_lambda(h));
    else
        return h / (h + smith_lambda_times_h(h));
}

/// S = (1 - erfc(h)/2)/(1 + Lambda): the same share of all facets, facing or not (thesis 6.25).
template <class Real>
Real smith_s(const Real& h) {
    return fma(constant<Real>(-0.5), erfc(h), Real(1)) * smith_g1(h);
}

}  // namespace brewster
