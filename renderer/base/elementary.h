#pragma once
#include <type_traits>

#include "base/lanes.h"

/// Elementary functions without the C library for float and its batch, so that both give the same bits on every
/// machine; double, the oracle's type, takes the C library. Bounds are measured against the C library's double.
namespace brewster {

/// Sine and cosine of a whole turn's fraction.
template <class Real>
struct SineCosine {
    Real sine, cosine;
};

/// sin and cos of 2 pi turns, turns in [0, 1). Absolute error below 2e-7 in float.
/// The reduction to an eighth of a turn is exact; Taylor polynomials on [-pi/4, pi/4].
template <class Real>
SineCosine<Real> sincos_turns(Real turns) {
    const Real quarter = floor(fma(turns, Real(4), constant<Real>(0.5)));
    const Real x = fma(turns, Real(4), -quarter) * constant<Real>(1.57079632679489661923);
    Real s, c;
    if constexpr (std::is_same_v<Real, double>) {
        s = std::sin(x);
        c = std::cos(x);
    } else {
        const Real xx = x * x;
        Real p = constant<Real>(2.7557319223985893e-6);
        p = fma(p, xx, constant<Real>(-1.9841269841269841e-4));
        p = fma(p, xx, constant<Real>(8.3333333333333333e-3));
        p = fma(p, xx, constant<Real>(-1.6666666666666667e-1));
        s = fma(p * xx, x, x);
        p = constant<Real>(2.4801587301587302e-5);
        p = fma(p, xx, constant<Real>(-1.3888888888888889e-3));
        p = fma(p, xx, constant<Real>(4.1666666666666667e-2));
        p = fma(p, xx, constant<Real>(-0.5));
        c = fma(p, xx, Real(1));
    }
    const Real half = floor(quarter * constant<Real>(0.5));
    const auto odd = fma(half, Real(-2), quarter) > constant<Real>(0.5);
    const auto lower = fma(floor(half * constant<Real>(0.5)), Real(-2), half) > constant<Real>(0.5);
    const Real sine = select(odd, c, s);
    const Real cosine = select(odd, s, c);
    return {select(lower, -sine, sine), select((odd && !lower) || (!odd && lower), -cosine, cosine)};
}

/// e^x. Float: relative error below 1.2e-7 where the result is normal; 0 below -87.33, e^88.37 above 88.37.
template <class Real>
[[gnu::always_inline]] inline Real exp_of(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::exp(x);
    } else {
        const Real bounded = max(min(x, constant<Real>(88.37)), constant<Real>(-87.33));
        const Real k = round_even(bounded * constant<Real>(1.44269504088896341));
        // ln 2 in two parts: k times the first is exact.
        const Real r = fma(k, constant<Real>(2.12194440054690583e-4), fma(k, constant<Real>(-0.693359375), bounded));
        Real p = constant<Real>(1.0 / 5040);
        p = fma(p, r, constant<Real>(1.0 / 720));
        p = fma(p, r, constant<Real>(1.0 / 120));
        p = fma(p, r, constant<Real>(1.0 / 24));
        p = fma(p, r, constant<Real>(1.0 / 6));
        p = fma(p, r, constant<Real>(0.5));
        p = fma(p * r, r, r);
        const Real scale = power_of_two(k);
        return select(x < constant<Real>(-87.33), Real(0), fma(p, scale, scale));
    }
}

/// ln x for x > 0. Float: relative error below 1.5e-7, denormals included; -103.97 at 0 (below the smallest denormal).
template <class Real>
Real log_of(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::log(x);
    } else {
        const auto small = x < constant<Real>(1.17549435e-38);
        const Real normal = max(select(small, x * constant<Real>(0x1p24), x), constant<Real>(1.17549435e-38));
        const MantissaExponent<Real> split = split_exponent(normal);
        const Real exponent = select(small, split.exponent - 24, split.exponent);
        // ln(1 + f) = 2 atanh(f / (2 + f))
        const Real f = split.mantissa - 1;
        const Real s = f / (2 + f);
        const Real ss = s * s;
        Real p = constant<Real>(2.0 / 9);
        p = fma(p, ss, constant<Real>(2.0 / 7));
        p = fma(p, ss, constant<Real>(2.0 / 5));
        p = fma(p, ss, constant<Real>(2.0 / 3));
        // 2 s = f - s f, so that f enters unrounded.
        const Real tail = fma(s, fma(p, ss, -f), exponent * constant<Real>(-2.12194440054690583e-4));
        return fma(exponent, constant<Real>(0.693359375), f + tail);
    }
}

/// e^(x^2) erfc(x), the scaled complementary error function, x >= 0 (not for double).
/// Float: relative error below 4e-7. Chebyshev interpolation of erfcx(x)/t in t = 1/(1 + 0.4 x), degree 10.
template <class Real>
[[gnu::always_inline]] inline Real erfcx(Real x) {
    static_assert(!std::is_same_v<Real, double>);
    const Real t = 1 / fma(constant<Real>(0.4), x, Real(1));
    const Real u = fma(t, Real(2), Real(-1));
    Real p = constant<Real>(-2.91685825e-5);
    p = fma(p, u, constant<Real>(-1.07462366e-5));
    p = fma(p, u, constant<Real>(0.000266488318));
    p = fma(p, u, constant<Real>(0.00016544152));
    p = fma(p, u, constant<Real>(-0.00192138204));
    p = fma(p, u, constant<Real>(-0.00335315529));
    p = fma(p, u, constant<Real>(0.0113435468));
    p = fma(p, u, constant<Real>(0.0684997675));
    p = fma(p, u, constant<Real>(0.1815657));
    p = fma(p, u, constant<Real>(0.321860774));
    p = fma(p, u, constant<Real>(0.421612728));
    return t * p;
}

/// 1 - erf x. Float: relative error below 1e-6 for 0 <= x < 3, growing to 2e-5 at 9; absolute error below 4e-7 for x <
/// 0.
template <class Real>
Real erfc_of(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::erfc(x);
    } else {
        const Real magnitude = abs(x);
        const Real upper = exp_of(-x * x) * erfcx(magnitude);
        return select(x < 0, 2 - upper, upper);
    }
}

/// The error function. Float: relative error below 4e-7.
template <class Real>
Real erf_of(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::erf(x);
    } else {
        const Real xx = x * x;
        Real p = constant<Real>(1.0 / 9360);
        p = fma(p, xx, constant<Real>(-1.0 / 1320));
        p = fma(p, xx, constant<Real>(1.0 / 216));
        p = fma(p, xx, constant<Real>(-1.0 / 42));
        p = fma(p, xx, constant<Real>(0.1));
        p = fma(p, xx, constant<Real>(-1.0 / 3));
        p = fma(p, xx, Real(1));
        const Real near_zero = constant<Real>(1.12837916709551257390) * x * p;
        const Real far = 1 - exp_of(-xx) * erfcx(abs(x));
        return select(xx < constant<Real>(0.25), near_zero, select(x < 0, -far, far));
    }
}

/// Arc cosine for x in [-1, 1]. Float: absolute error below 6e-7 (Abramowitz and Stegun 4.4.46).
template <class Real>
Real acos_of(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::acos(x);
    } else {
        const Real magnitude = min(abs(x), Real(1));
        Real p = constant<Real>(-0.0012624911);
        p = fma(p, magnitude, constant<Real>(0.0066700901));
        p = fma(p, magnitude, constant<Real>(-0.0170881256));
        p = fma(p, magnitude, constant<Real>(0.0308918810));
        p = fma(p, magnitude, constant<Real>(-0.0501743046));
        p = fma(p, magnitude, constant<Real>(0.0889789874));
        p = fma(p, magnitude, constant<Real>(-0.2145988016));
        p = fma(p, magnitude, constant<Real>(1.5707963050));
        const Real acute = sqrt(1 - magnitude) * p;
        return select(x < 0, constant<Real>(3.14159265358979324) - acute, acute);
    }
}

// Not templates, so that argument-dependent lookup prefers them to the SIMD library's, which have other bits.
inline float exp(float x) {
    return exp_of(x);
}
inline double exp(double x) {
    return exp_of(x);
}
inline FloatLanes exp(FloatLanes x) {
    return exp_of(x);
}
inline float log(float x) {
    return log_of(x);
}
inline double log(double x) {
    return log_of(x);
}
inline FloatLanes log(FloatLanes x) {
    return log_of(x);
}
inline float erfc(float x) {
    return erfc_of(x);
}
inline double erfc(double x) {
    return erfc_of(x);
}
inline FloatLanes erfc(FloatLanes x) {
    return erfc_of(x);
}
inline float erf(float x) {
    return erf_of(x);
}
inline double erf(double x) {
    return erf_of(x);
}
inline FloatLanes erf(FloatLanes x) {
    return erf_of(x);
}
inline float acos(float x) {
    return acos_of(x);
}
inline double acos(double x) {
    return acos_of(x);
}
inline FloatLanes acos(FloatLanes x) {
    return acos_of(x);
}

/// 1 - e^-x for x >= 0, without cancellation. Float: relative error below 4e-7.
template <class Real>
Real one_minus_exp(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return -std::expm1(-x);
    } else {
        Real p = fma(x, constant<Real>(1.0 / 120), constant<Real>(-1.0 / 24));
        p = fma(p, x, constant<Real>(1.0 / 6));
        p = fma(p, x, constant<Real>(-0.5));
        return select(x < constant<Real>(0.125), fma(p * x, x, x), 1 - exp_of(-x));
    }
}

}  // namespace brewster
