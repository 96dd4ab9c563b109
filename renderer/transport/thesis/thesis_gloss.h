#pragma once
#include <algorithm>

#include "optics/thesis_sampler.h"
#include "transport/meeting.h"
#include "transport/sampling.h"

/// Gloss as the thesis draws it (7.39 to 7.53), with its acceptance S F (theory 3.7). The bias is the thesis's own.
namespace brewster::transport {

/// Whether the thesis's sampler is meant for the surface.
inline bool drawn_by_thesis(const PreparedMaterial& material) {
    return material.finish == Finish::beckmann && material.reflects() && material.base != Base::transparent;
}

/// Like sample_gloss, for materials of drawn_by_thesis; its density is not known.
template <int bands>
Sample<float, bands> thesis_gloss(const PreparedMaterial& material, const SurfacePoint<float>& at,
                                  const ScatterNumbers<float>& numbers) {
    const Vector<float> arriving = -at.towards;
    const PlaneOfIncidence<float> plane = plane_of_incidence(arriving, at.carried_axis, at.normal);
    const float m = material.slope;
    const FacetSlopes<float> slopes = sample_thesis_slopes(plane.cos_theta_i, m, numbers.facet_u, numbers.facet_v);
    const Vector<float> facet = normalized(add_scaled(m * slopes.along, cross(plane.axis, at.normal),
                                                      add_scaled(m * slopes.across, plane.axis, at.normal)));
    const PlaneOfIncidence<float> facet_plane = plane_of_incidence(arriving, at.carried_axis, facet);
    Sample<float, bands> sample{};
    sample.direction = reflected(arriving, facet);
    sample.axis = facet_plane.axis;
    sample.turn = facet_plane.turn;
    sample.alive = dot(sample.direction, at.normal) > 1e-6f && dot(at.towards, facet) > 0;
    const float seen = smith_s(cotangent_over_slope(plane.cos_theta_i, m));
    constexpr auto count = static_cast<std::size_t>(bands);
    sample.weight = bsdf_detail::reflection<count>(material, facet_plane.cos_theta_i);
    bsdf_detail::scale(sample.weight, seen);
    return sample;
}

/// The way on that was drawn among all lobes, with gloss by the thesis in the place of gloss, from numbers of its own.
/// Whether the interface or the base sends the photon on stays, so that the base gets its share.
template <int bands>
Sample<float, bands> thesis_scattered(const PreparedMaterial& material, const SurfacePoint<float>& at,
                                      const Sample<float, bands>& sample, const ScatterNumbers<float>& gloss) {
    if (sample.base || !drawn_by_thesis(material)) return sample;
    Sample<float, bands> drawn = thesis_gloss<bands>(material, at, gloss);
    if (material.diffuse()) {
        constexpr auto count = static_cast<std::size_t>(bands);
        const float chosen = 1 - bsdf_detail::base_probability<count>(material, dot(at.towards, at.normal));
        bsdf_detail::scale(drawn.weight, 1 / std::max(chosen, 1e-6f));
    }
    return drawn;
}

}  // namespace brewster::transport
