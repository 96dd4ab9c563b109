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

/// Error below two roundings of |a| |b|.
template <class Real>
[[gnu::always_inline]] inline Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
}

/// a of any non-zero length, made unit.
template <class Real>
Vector<Real> normalized(const Vector<Real>& a) {
    return (1 / sqrt(dot(a, a))) * a;
}

/// a of length 1 + e made of length 1 + O(e^2): keeps long chains of events from drifting.
template <class Real>
[[gnu::always_inline]] inline Vector<Real> unit_again(const Vector<Real>& a) {
    return fma(constant<Real>(-0.5), dot(a, a), constant<Real>(1.5)) * a;
}

template <class Real>
Vector<Real> select(const auto& mask, const Vector<Real>& a, const Vector<Real>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

}  // namespace brewster
