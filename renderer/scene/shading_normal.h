#pragma once
#include "optics/vector.h"

namespace brewster {

inline constexpr double largest_normal_correction = 2;

/// What a photon's weight is multiplied by where a smooth mesh is shaded with the normal N_s of the surface it stands
/// for, while it is hit and left by the facet with N_g: |i.N_s| |r.N_g| / (|i.N_g| |r.N_s|), capped at 2 (Veach 1997,
/// 5.3; theory 4.1). i and r are unit, either way along their rays; 1 for equal normals. The eye's side needs no
/// correction: there f |cos N_s| is the integrand itself.
template <class Real>
Real shading_normal_correction(const Vector<Real>& i, const Vector<Real>& r, const Vector<Real>& shading_normal,
                               const Vector<Real>& normal) {
    const Real above = abs(dot(i, shading_normal) * dot(r, normal));
    const Real below = abs(dot(i, normal) * dot(r, shading_normal));
    const auto capped = above >= constant<Real>(largest_normal_correction) * below;
    return select(capped, constant<Real>(largest_normal_correction), above / select(capped, Real(1), below));
}

}  // namespace brewster
