#pragma once
#include <array>

#include "bins/direction_map.h"
#include "transport/context.h"
#include "transport/meeting.h"
#include "transport/numbers.h"
#include "transport/path.h"
#include "transport/sampling.h"

/// What the bins want to know of light that arrives at a surface, before any choice of survival.
namespace brewster::transport {

/// Light that enters a base, per world and band.
template <class Real, int bands>
struct EnteringLight {
    MaskOf<Real> filed;  ///< where not, a shading normal turns away
    std::array<Real, static_cast<std::size_t>(2 * bands)> weights;
};

/// Through the interface by its passage, per world. Under a shading normal the flux per area of the surface that is
/// meant differs from that of the facet by the ratio of the cosines.
template <class Real, int components, int bands>
EnteringLight<Real, bands> entering_light(const Meeting<Real>& at, const Vector<Real>& direction,
                                          const PhotonLight<Real, components, bands>& light) {
    EnteringLight<Real, bands> entering;
    const Real ratio = filed_ratio(direction, at);
    entering.filed = ratio > 0;
    const PlaneOfIncidence<Real> plane = plane_of_incidence(direction, light.axis, at.shading_normal);
    for (int band = 0; band < bands; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const Passage<Real> passage = at.material->passage(b, plane.cos_theta_i);
        const Stokes<Real, components> turned = rotate(plane.turn, light.polarized[b]);
        entering.weights[b] = ratio * fma(passage.unpolarized, turned.s0(), passage.s_minus_p * turned.s1());
        entering.weights[b + bands] = ratio * passage.unpolarized * light.power(1, band);
    }
    return entering;
}

/// One event: Mueller matrices for the polarized world, their m00 for the other.
template <class Real, int components, int bands>
void scatter_by(const Sample<Real, bands>& sample, PhotonLight<Real, components, bands>& light) {
    for (std::size_t b = 0; b < bands; ++b) {
        light.polarized[b] = made_realizable(sample.weight[b] * rotate(sample.turn, light.polarized[b]));
        if constexpr (components > 1) light.unpolarized[b] = light.unpolarized[b] * sample.weight[b].m00;
    }
    light.axis = sample.axis;
}

inline constexpr std::uint32_t gloss_deposits = 4;  ///< directions filed for each arrival

/// What chance decides at an arrival: numbers for the way on, and the direction of its lobe that the interface would
/// send the light into, which is filed whether it is the way on or not.
template <class Real, int bands>
struct Event {
    EventNumbers<Real> numbers;
    Sample<Real, bands> gloss;  ///< where has_gloss(material); else not filled in
};

template <class Real, int components, int bands>
SurfacePoint<Real> surface_point(const Meeting<Real>& at, const Vector<Real>& direction,
                                 const PhotonLight<Real, components, bands>& light) {
    return {-direction, light.axis, at.shading_normal, at.inside, at.filter_axis};
}

/// How many directions an arrival files, the event's own among them. A mirror sends all light one way, and cells that
/// are wider than the lobes would take in many for one.
inline std::uint32_t deposits_of(const PreparedMaterial& material, bool coarse) {
    return material.rough() && !coarse ? gloss_deposits : 1;
}

/// Light that the interface sends on in one of several directions of its own lobe: its share of the whole.
template <class Real, int components, int bands>
struct GlossLight {
    MaskOf<Real> filed;
    std::array<Word<Real>, 2> square;  ///< the direction, fixed-point
    std::array<Real, PhotonLight<Real, components, bands>::numbers> weights;
};

/// The frame that directions of gloss stand in: relative to the shading normal, in the frame that comes from the chart's
/// by the shortest turn, so that a lobe stands still across a curved cell.
template <class Real>
struct GlossFrame {
    Real ratio;  ///< filed_ratio
    Vector<Real> tangent_u, tangent_v;
};

template <class Real>
GlossFrame<Real> gloss_frame(const Meeting<Real>& at, const Vector<Real>& direction) {
    return {filed_ratio(direction, at), transported_axis(at.chart_normal, at.axis_u, at.shading_normal),
            transported_axis(at.chart_normal, at.axis_v, at.shading_normal)};
}

/// Light sent the way of `sample`, which stands for a `share` of all ways. `coarse`: of charts whose cells take mirrors,
/// too.
template <class Real, int components, int bands>
GlossLight<Real, components, bands> gloss_light(const Meeting<Real>& at, const GlossFrame<Real>& frame,
                                                const PhotonLight<Real, components, bands>& light,
                                                const Sample<Real, bands>& sample, bool coarse, float share) {
    GlossLight<Real, components, bands> gloss;
    gloss.filed = frame.ratio > 0 && sample.alive && dot(sample.direction, at.normal) > 0;
    if (!coarse) gloss.filed = gloss.filed && !sample.sharp;
    PhotonLight<Real, components, bands> sent = light;
    scatter_by(sample, sent);
    const Vector<Real> axis = transported_axis(at.shading_normal, frame.tangent_u, sample.direction);
    gloss.weights = sent.gloss_fields(rotation_between(sample.direction, sample.axis, axis), frame.ratio * Real(share));
    const auto square = direction_map::direction_square_of(dot(sample.direction, frame.tangent_u),
                                                           dot(sample.direction, frame.tangent_v));
    gloss.square = {fixed_coordinate(square.x), fixed_coordinate(square.y)};
    return gloss;
}

}  // namespace brewster::transport
