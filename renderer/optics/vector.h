#pragma once
#include "base/lanes.h"

namespace brewster {

/// Three Cartesian coordinates. Directions are unit vectors; what points where stands in conventions.h.
template <class Real>
struct Vector {
    Real x{}, y{}, z{};

    friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
    friend Vector operator*(const Real& scale, const Vector& a) { return {scale * a.x, scale * a.y, scale * a.z}; }
};

template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}

/// scale * a + b with one rounding a coordinate.
template <class Real>
Vector<Real> add_scaled(const Real& scale, const Vector<Real>& a, const Vector<Real>& b) {
    return {fma(scale, a.x, b.x), fma(scale, a.y, b.y), fma(scale, a.z, b.z)};
}

/// a b - c d without cancellation: error below 1.5 units in the last place (Kahan; Jeannerod et al. 2013,
/// doi:10.1090/S0025-5718-2013-02679-8).
template <class Real>
Real difference_of_products(const Real& a, const Real& b, const Real& c, const Real& d) {
    const Real cd = c * d;
    return fma(a, b, -cd) + fma(-c, d, cd);
}

template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// a of any non-zero length, made unit.
template <class Real>
Vector<Real> normalized(const Vector<Real>& a) {
    return (1 / sqrt(dot(a, a))) * a;
}

/// a of length 1 + e made of length 1 + O(e^2): keeps long chains of events from drifting.
template <class Real>
Vector<Real> unit_again(const Vector<Real>& a) {
    return fma(constant<Real>(-0.5), dot(a, a), constant<Real>(1.5)) * a;
}

template <class Real>
Vector<Real> select(const auto& mask, const Vector<Real>& a, const Vector<Real>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

}  // namespace brewster
