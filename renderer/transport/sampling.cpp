#include "transport/sampling.h"

namespace brewster::transport {

template <class Real, int bands>
Sample<Real, bands> scattered(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                              const ScatterNumbers<Real>& numbers, const Sample<Real, bands>& gloss) {
    return sample_bsdf<Use::light, static_cast<std::size_t>(bands)>(material, at, numbers, gloss);
}

template <class Real, int bands>
Sample<Real, bands> glossy(const PreparedMaterial& material, const SurfacePoint<Real>& at,
                           const ScatterNumbers<Real>& numbers) {
    return sample_gloss<static_cast<std::size_t>(bands)>(material, at, numbers);
}

#define BREWSTER_SAMPLERS(Real, bands)                                                                            \
    template Sample<Real, bands> scattered<Real, bands>(const PreparedMaterial&, const SurfacePoint<Real>&,       \
                                                        const ScatterNumbers<Real>&, const Sample<Real, bands>&); \
    template Sample<Real, bands> glossy<Real, bands>(const PreparedMaterial&, const SurfacePoint<Real>&,          \
                                                     const ScatterNumbers<Real>&);
BREWSTER_SAMPLERS(float, 1)
BREWSTER_SAMPLERS(float, 3)
BREWSTER_SAMPLERS(FloatLanes, 1)
BREWSTER_SAMPLERS(FloatLanes, 3)
#undef BREWSTER_SAMPLERS

}  // namespace brewster::transport
