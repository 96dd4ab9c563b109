#pragma once
#include "scene/bsdf.h"

/// The samplers of bsdf.h, compiled once for all kernels of as many bands (sampling.cpp).
namespace brewster::transport {

template <class Real, int bands>
using Sample = ScatterSample<Real, static_cast<std::size_t>(bands)>;

/// sample_bsdf of light. `gloss`: glossy of the same numbers where has_gloss(material).
template <class Real, int bands>
Sample<Real, bands> scattered(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                              const ScatterNumbers<Real>& numbers, const Sample<Real, bands>& gloss);

/// sample_gloss.
template <class Real, int bands>
Sample<Real, bands> glossy(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                           const ScatterNumbers<Real>& numbers);

}  // namespace brewster::transport
