#pragma once
#include "optics/stokes.h"
#include "optics/vector.h"

namespace brewster {

/// A turn of the frame by t about the direction of propagation, counter-clockwise seen by the receiver, as the
/// cosine and sine of 2 t: all that a Stokes vector sees, and free of trigonometry.
template <class Real>
struct FrameRotation {
    Real cos_2t{1}, sin_2t{0};

    FrameRotation inverse() const { return {cos_2t, -sin_2t}; }
};

/// The same light in the frame turned by t (thesis 3.26): S1' = cos 2t S1 + sin 2t S2, S2' = -sin 2t S1 + cos 2t S2.
template <class Real, int components>
[[gnu::always_inline]] inline Stokes<Real, components> rotate(const FrameRotation<Real>& turn,
                                                              const Stokes<Real, components>& light) {
    if constexpr (components == 1) {
        return light;
    } else {
        return stokes_of<components>(light.s0(), fma(turn.cos_2t, light.s1(), turn.sin_2t * light.s2()),
                                     fma(turn.cos_2t, light.s2(), -turn.sin_2t * light.s1()), light.s3());
    }
}

/// From t's cosine and sine, up to a common positive factor. Both zero: no turn.
template <class Real>
FrameRotation<Real> rotation_of(const Real& cos_t, const Real& sin_t) {
    const Real norm = fma(cos_t, cos_t, sin_t * sin_t);
    const auto defined = norm > 0;
    const Real scale = 1 / select(defined, norm, Real(1));
    return {select(defined, (cos_t - sin_t) * (cos_t + sin_t) * scale, Real(1)), 2 * cos_t * sin_t * scale};
}

/// The turn about `direction` that takes the axis `from` to the axis `to`; both unit and orthogonal to `direction`.
template <class Real>
FrameRotation<Real> rotation_between(const Vector<Real>& direction, const Vector<Real>& from, const Vector<Real>& to) {
    return rotation_of(dot(from, to), dot(direction, cross(from, to)));
}

/// Where a photon meets a surface or facet: the plane of incidence and the turn into it.
template <class Real>
struct PlaneOfIncidence {
    Vector<Real> axis;         ///< s = k x n / |k x n|: the x axis before and after the event
    FrameRotation<Real> turn;  ///< from the carried axis to `axis`
    Real cos_theta_i;          ///< -k.n in [0, 1]
};

/// `direction` k and `carried_axis` are unit and orthogonal; `normal` is unit and faces the photon.
/// In the carried frame (s, p = k x s) the plane's axis is ((n.s) p - (n.p) s) / sin theta, so it is orthogonal to k as
/// well as s is, at every angle. Below sin theta = 1e-14 (1e-12 in float), where any axis is right, the carried one
/// stays. The printed recipe, theta = acos(s_i.s_n) (thesis 7.60), loses the sign of sin 2t and half the digits.
template <class Real>
[[gnu::always_inline]] inline PlaneOfIncidence<Real> plane_of_incidence(const Vector<Real>& direction,
                                                                        const Vector<Real>& carried_axis,
                                                                        const Vector<Real>& normal) {
    const Vector<Real> p = cross(direction, carried_axis);
    const Real along_s = dot(normal, carried_axis);
    const Real along_p = dot(normal, p);
    const Real sin_squared = fma(along_s, along_s, along_p * along_p);
    const auto oblique = sin_squared > constant<Real>(std::is_same_v<Real, double> ? 1e-28 : 1e-24);
    const Real scale = 1 / select(oblique, sin_squared, Real(1));
    const Real length_scale = sqrt(scale);
    const Real on_s = select(oblique, -along_p * length_scale, Real(1));
    const Real on_p = select(oblique, along_s * length_scale, Real(0));
    const FrameRotation<Real> turn{select(oblique, (along_p - along_s) * (along_p + along_s) * scale, Real(1)),
                                   select(oblique, -2 * along_p * along_s * scale, Real(0))};
    return {unit_again(add_scaled(on_s, carried_axis, on_p * p)), turn,
            max(min(-dot(direction, normal), Real(1)), Real(0))};
}

/// k + 2 cos(theta) n: the mirrored direction.
template <class Real>
[[gnu::always_inline]] inline Vector<Real> reflected(const Vector<Real>& direction, const Vector<Real>& normal) {
    return unit_again(add_scaled(-2 * dot(direction, normal), normal, direction));
}

/// The axis obtained by carrying the surface's tangent from the normal to `direction` along the great circle:
/// T - (T.d)/(1 + N.d) (N + d). Unit and orthogonal to d, smooth wherever N.d > -1; the frame of tallied light.
template <class Real>
Vector<Real> transported_axis(const Vector<Real>& normal, const Vector<Real>& tangent, const Vector<Real>& direction) {
    const Real scale = dot(-tangent, direction) / (1 + dot(normal, direction));
    return add_scaled(scale, normal + direction, tangent);
}

}  // namespace brewster
