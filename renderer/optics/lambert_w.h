#pragma once
#include "base/elementary.h"

namespace brewster {

/// W(k) from y = ln k: the root w > 0 of w + ln w = y, that is of w e^w = k. Any finite y.
/// A start within a few per cent, then two steps of order four (Fritsch, Shafer and Crowley 1973).
/// Relative error: |y| roundings below y = -2, a few elsewhere.
template <class Real>
Real lambert_w_of_log(const Real& y) {
    const Real k = exp(min(y, constant<Real>(1.5)));
    const auto tiny = y < -36;
    const Real small = k * fma(-k, fma(constant<Real>(-1.5), k, Real(1)), Real(1));
    const Real l = log(1 + k);
    const Real middle = l * (1 - log(1 + l) / (2 + l));
    const Real bounded = max(y, constant<Real>(1.5));
    const Real large = bounded - log(bounded - log(bounded));
    Real w = select(y < -2, small, select(y < constant<Real>(1.5), middle, large));
    w = select(tiny, Real(1), w);
    for (int step = 0; step < 2; ++step) {
        const Real z = y - log(w) - w;
        const Real up = 1 + w;
        const Real p = 2 * up * fma(constant<Real>(2.0 / 3), z, up);
        w = fma(w, z / up * ((p - z) / fma(Real(-2), z, p)), w);
    }
    return select(tiny, k, w);
}

/// W(k), k >= 0 (thesis 7.56).
template <class Real>
Real lambert_w(const Real& k) {
    const auto tiny = k < constant<Real>(1e-16);
    return select(tiny, k, lambert_w_of_log(log(select(tiny, Real(1), k))));
}

}  // namespace brewster
