#pragma once
#include <array>
#include <cmath>

#include "base/units.h"
#include "optics/frame.h"
#include "optics/stokes.h"

namespace brewster {

/// A 4 x 4 Mueller matrix, row by row.
template <class Real>
struct Mueller {
    std::array<std::array<Real, 4>, 4> m{};

    const std::array<Real, 4>& operator[](int row) const { return m[static_cast<unsigned>(row)]; }

    /// In light order: (b * a) * light passes a first.
    friend Mueller operator*(const Mueller& b, const Mueller& a) {
        Mueller product;
        for (unsigned row = 0; row < 4; ++row)
            for (unsigned column = 0; column < 4; ++column)
                product.m[row][column] = fma(
                    b.m[row][0], a.m[0][column],
                    fma(b.m[row][1], a.m[1][column], fma(b.m[row][2], a.m[2][column], b.m[row][3] * a.m[3][column])));
        return product;
    }
};

template <class Real, int components>
Stokes<Real, components> operator*(const Mueller<Real>& element, const Stokes<Real, components>& light) {
    Stokes<Real, components> out;
    for (unsigned row = 0; row < components; ++row)
        out.s[row] =
            fma(element.m[row][0], light.s0(),
                fma(element.m[row][1], light.s1(), fma(element.m[row][2], light.s2(), element.m[row][3] * light.s3())));
    return out;
}

/// The matrix of an isotropic interface in the frame of its plane of incidence,
/// [[a,b,0,0], [b,a,0,0], [0,0,c,-d], [0,0,d,c]] (thesis 4.11, with d for total reflection and conductors).
template <class Real>
struct InterfaceMueller {
    Real a, b, c, d;
};

template <class Real, int components>
[[gnu::always_inline]] inline Stokes<Real, components> operator*(const InterfaceMueller<Real>& event,
                                                                 const Stokes<Real, components>& light) {
    if constexpr (components == 1) {
        return {{event.a * light.s0()}};
    } else {
        return stokes_of<components>(
            fma(event.a, light.s0(), event.b * light.s1()), fma(event.b, light.s0(), event.a * light.s1()),
            fma(event.c, light.s2(), -event.d * light.s3()), fma(event.d, light.s2(), event.c * light.s3()));
    }
}

template <class Real>
Mueller<Real> full_matrix(const InterfaceMueller<Real>& event) {
    return {
        {{{event.a, event.b, 0, 0}, {event.b, event.a, 0, 0}, {0, 0, event.c, -event.d}, {0, 0, event.d, event.c}}}};
}

/// The change of frame as a matrix (thesis 3.26, there called a rotator).
template <class Real>
Mueller<Real> frame_matrix(const FrameRotation<Real>& turn) {
    return {{{{1, 0, 0, 0}, {0, turn.cos_2t, turn.sin_2t, 0}, {0, -turn.sin_2t, turn.cos_2t, 0}, {0, 0, 0, 1}}}};
}

/// The element turned by t, counter-clockwise seen by the receiver: R(-t) M R(t) (thesis 3.31).
template <class Real>
Mueller<Real> rotated(const Mueller<Real>& element, const FrameRotation<Real>& turn) {
    return frame_matrix(turn.inverse()) * (element * frame_matrix(turn));
}

/// The turn by an angle in radians; not for the photon loop.
inline FrameRotation<double> turn_by(double angle) {
    return {std::cos(2 * angle), std::sin(2 * angle)};
}

/// Elements, each with its own axis along x; turn them with `rotated`.
namespace elements {

/// Amplitude transmissions px, py in [0, 1] along x and y (thesis 3.5).
template <class Real>
Mueller<Real> diattenuator(const Real& px, const Real& py) {
    const Real a = constant<Real>(0.5) * fma(px, px, py * py);
    const Real b = constant<Real>(0.5) * (px - py) * (px + py);
    const Real q = px * py;
    return {{{{a, b, 0, 0}, {b, a, 0, 0}, {0, 0, q, 0}, {0, 0, 0, q}}}};
}

/// Passes x, stops y.
template <class Real>
Mueller<Real> polarizer() {
    return diattenuator(Real(1), Real(0));
}

/// Delays y against x by the retardance, given by its cosine and sine: fast axis x. The thesis's (3.9) is the same
/// plate with its fast axis along y, although its (3.6) says x.
template <class Real>
Mueller<Real> retarder_fast_x(const Real& cos_retardance, const Real& sin_retardance) {
    return {{{{1, 0, 0, 0},
              {0, 1, 0, 0},
              {0, 0, cos_retardance, sin_retardance},
              {0, 0, -sin_retardance, cos_retardance}}}};
}

/// The same plate with its fast axis along y.
template <class Real>
Mueller<Real> retarder_fast_y(const Real& cos_retardance, const Real& sin_retardance) {
    return retarder_fast_x(cos_retardance, -sin_retardance);
}

template <class Real>
Mueller<Real> quarter_wave_fast_x() {
    return retarder_fast_x(Real(0), Real(1));
}

/// Maps +45 degrees to -45 degrees and right to left; it makes no circular light.
template <class Real>
Mueller<Real> half_wave_fast_x() {
    return retarder_fast_x(Real(-1), Real(0));
}

/// Passes right circular light and stops left; its light is right circular.
template <class Real>
Mueller<Real> right_circular_polarizer() {
    const Real half = constant<Real>(0.5);
    return {{{{half, 0, 0, half}, {0, 0, 0, 0}, {0, 0, 0, 0}, {half, 0, 0, half}}}};
}

template <class Real>
Mueller<Real> left_circular_polarizer() {
    const Real half = constant<Real>(0.5);
    return {{{{half, 0, 0, -half}, {0, 0, 0, 0}, {0, 0, 0, 0}, {-half, 0, 0, half}}}};
}

/// A mirror at normal incidence: swaps handedness and the sign of S2 (the y axis turns with the direction).
template <class Real>
Mueller<Real> mirror_at_normal_incidence() {
    return {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, -1}}}};
}

template <class Real>
Mueller<Real> depolarizer() {
    return {{{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}}};
}

/// A plate of birefringence (n_slow - n_fast) and thickness at a wavelength, both lengths in the same unit; fast axis
/// x. Only the fraction of a wave beyond the last whole one enters the sine, so thick plates keep their digits.
inline Mueller<double> waveplate_fast_x(double birefringence, double thickness, double wavelength) {
    const double waves = birefringence * thickness / wavelength;
    const double retardance = 2 * pi * (waves - std::floor(waves));
    return retarder_fast_x(std::cos(retardance), std::sin(retardance));
}

}  // namespace elements

}  // namespace brewster
