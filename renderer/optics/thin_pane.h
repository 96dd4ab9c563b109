#pragma once
#include "optics/fresnel.h"
#include "optics/planar_mueller.h"

namespace brewster {

/// A plane parallel plate between the same medium on both sides, thick against the coherence length of light: all
/// internal reflections add as powers.
template <class Real>
struct ThinPane {
    PlanarMueller<Real> reflection, transmission;  ///< power, in the s frame; lossless: their m00 add up to 1
};

/// Inside, each reflection has the outside's matrix again (rs and rp both change sign), so s, p and (S2, S3) are
/// geometric series: R + T^2 R/(1 - R^2) = 2R/(1 + R), T^2/(1 - R^2) = (1 - R)/(1 + R); (S2, S3): c + q^2 c/(1 - c^2)
/// and q^2/(1 - c^2). cos_theta in [0, 1], n >= 1 the plate's index over that outside.
template <class Real>
ThinPane<Real> thin_pane(const Real& cos_theta, const Real& n) {
    const DielectricInterface<Real> face = dielectric_interface(cos_theta, n);
    const Real half = constant<Real>(0.5);
    const Real rs = 2 * face.Rs / (1 + face.Rs), rp = 2 * face.Rp / (1 + face.Rp);
    const Real c = face.reflection.c, q = face.transmission.c;
    const Real through = q * q / max(1 - c * c, constant<Real>(1e-30));
    const Real a = half * (rs + rp), b = half * (rs - rp);
    return {{a, b, b, a, fma(through, c, c), Real(0)}, {1 - a, -b, -b, 1 - a, through, Real(0)}};
}

}  // namespace brewster
