#pragma once
#include "optics/mueller.h"
#include "optics/polarized_diffuse.h"

namespace brewster {

/// The matrix of an event that keeps (S0, S1) and (S2, S3) apart, each segment in its own s frame:
/// [[m00,m01,0,0], [m10,m11,0,0], [0,0,c,-d], [0,0,d,c]]. Interfaces, panes and depolarizing bases all have this form.
template <class Real>
struct PlanarMueller {
    Real m00{}, m01{}, m10{}, m11{}, c{}, d{};

    friend PlanarMueller operator*(const Real& scale, const PlanarMueller& a) {
        return {scale * a.m00, scale * a.m01, scale * a.m10, scale * a.m11, scale * a.c, scale * a.d};
    }
};

template <class Real>
PlanarMueller<Real> planar(const InterfaceMueller<Real>& event) {
    return {event.a, event.b, event.b, event.a, event.c, event.d};
}

/// Light that enters by `in`, forgets its state and leaves by `out`: column times row (theory 5).
template <class Real>
PlanarMueller<Real> depolarized(const Passage<Real>& out, const Passage<Real>& in) {
    return {out.unpolarized * in.unpolarized,
            out.unpolarized * in.s_minus_p,
            out.s_minus_p * in.unpolarized,
            out.s_minus_p * in.s_minus_p,
            Real(0),
            Real(0)};
}

template <class Real, int components>
[[gnu::always_inline]] inline Stokes<Real, components> operator*(const PlanarMueller<Real>& event,
                                                                 const Stokes<Real, components>& light) {
    if constexpr (components == 1) {
        return {{event.m00 * light.s0()}};
    } else {
        return stokes_of<components>(
            fma(event.m00, light.s0(), event.m01 * light.s1()), fma(event.m10, light.s0(), event.m11 * light.s1()),
            fma(event.c, light.s2(), -event.d * light.s3()), fma(event.d, light.s2(), event.c * light.s3()));
    }
}

template <class Real>
Mueller<Real> full_matrix(const PlanarMueller<Real>& event) {
    const Real none(0);
    return {{{{event.m00, event.m01, none, none},
              {event.m10, event.m11, none, none},
              {none, none, event.c, -event.d},
              {none, none, event.d, event.c}}}};
}

template <class Real>
PlanarMueller<Real> select(const auto& mask, const PlanarMueller<Real>& a, const PlanarMueller<Real>& b) {
    return {select(mask, a.m00, b.m00), select(mask, a.m01, b.m01), select(mask, a.m10, b.m10),
            select(mask, a.m11, b.m11), select(mask, a.c, b.c),     select(mask, a.d, b.d)};
}

}  // namespace brewster
