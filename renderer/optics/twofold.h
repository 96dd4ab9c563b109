#pragma once
#include "base/lanes.h"

namespace brewster {

/// A number as the unevaluated sum hi + lo, about twice the digits of Real: for differences that cancel.
template <class Real>
struct Twofold {
    Real hi, lo;
};

/// a + b without error (Knuth).
template <class Real>
Twofold<Real> two_sum(const Real& a, const Real& b) {
    const Real sum = a + b;
    const Real back = sum - a;
    return {sum, (a - (sum - back)) + (b - back)};
}

/// a b without error, above underflow.
template <class Real>
Twofold<Real> two_product(const Real& a, const Real& b) {
    const Real product = a * b;
    return {product, fma(a, b, -product)};
}

template <class Real>
Twofold<Real> operator+(const Twofold<Real>& a, const Twofold<Real>& b) {
    const Twofold<Real> sum = two_sum(a.hi, b.hi);
    const Real low = sum.lo + (a.lo + b.lo);
    const Real high = sum.hi + low;
    return {high, low - (high - sum.hi)};
}

template <class Real>
Twofold<Real> square(const Twofold<Real>& a) {
    const Twofold<Real> high = two_product(a.hi, a.hi);
    return {high.hi, fma(2 * a.hi, a.lo, high.lo)};
}

/// p + q - 1.
template <class Real>
Twofold<Real> sum_minus_one(const Twofold<Real>& p, const Twofold<Real>& q) {
    const Twofold<Real> sum = two_sum(p.hi, q.hi);
    const Twofold<Real> rest = two_sum(sum.hi, Real(-1));
    const Real low = rest.lo + (sum.lo + (p.lo + q.lo));
    const Real high = rest.hi + low;
    return {high, low - (high - rest.hi)};
}

}  // namespace brewster
