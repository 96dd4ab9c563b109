#pragma once
#include "scene/bsdf.h"
#include "scene/landing.h"
#include "scene/shading_normal.h"

namespace brewster::transport {

/// Where photons meet surfaces: one, or a batch of lanes on one material and side of it.
template <class Real>
struct Meeting {
    const PreparedMaterial* material = nullptr;
    bool inside = false;                            ///< of a closed transparent body
    Vector<Real> position, normal, shading_normal;  ///< unit normals, on the side that was hit
    Word<Real> triangle{}, chart{}, u{}, v{};       ///< as in Hit
    Barycentric<Real> barycentric{};
    Vector<Real> chart_normal, axis_u, axis_v;  ///< of the chart
    Vector<Real> filter_axis;                   ///< of a filter sheet
};

/// |i.N_s| / |i.N_g|, by which the flux that enters a smooth mesh exceeds the photon's (theory 4.1); not positive where
/// the shading normal turns away from the light.
template <class Real>
Real cosine_ratio(const Vector<Real>& direction, const Meeting<Real>& at) {
    return dot(direction, at.shading_normal) / dot(direction, at.normal);
}

/// The same as a factor of what is filed, capped. Not positive: nothing is.
template <class Real>
Real filed_ratio(const Vector<Real>& direction, const Meeting<Real>& at) {
    return min(constant<Real>(largest_normal_correction), cosine_ratio(direction, at));
}

/// Whether the surface is shaded by another normal than its own.
template <class Real>
MaskOf<Real> is_bent(const Meeting<Real>& at) {
    return at.normal.x != at.shading_normal.x || at.normal.y != at.shading_normal.y ||
           at.normal.z != at.shading_normal.z;
}

}  // namespace brewster::transport
