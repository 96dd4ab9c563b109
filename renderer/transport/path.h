#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>

#include "optics/frame.h"
#include "optics/stokes.h"
#include "optics/vector.h"

namespace brewster {

inline Vector<float> float_vector(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
inline glm::vec3 glm_vector(const Vector<float>& v) {
    return {v.x, v.y, v.z};
}

/// What a photon carries, in units of photon weight: per band a Stokes vector in the frame of `axis`, and the power of
/// the same photon in the unpolarized world. With one component both worlds are the same and `unpolarized` is not used.
template <int components, int bands>
struct PhotonLight {
    static constexpr bool two_worlds = components > 1;
    static constexpr int worlds = two_worlds ? 2 : 1;

    std::array<Stokes<float, components>, bands> polarized{};
    std::array<float, two_worlds ? bands : 0> unpolarized{};
    Vector<float> axis{1, 0, 0};  ///< unit, orthogonal to the direction

    float power(int world, int band) const {
        const auto b = static_cast<std::size_t>(band);
        if constexpr (two_worlds) {
            if (world == 1) return unpolarized[b];
        }
        return polarized[b].s0();
    }
    float largest() const {
        float greatest = 0;
        for (int world = 0; world < worlds; ++world)
            for (int band = 0; band < bands; ++band) greatest = std::max(greatest, power(world, band));
        return greatest;
    }
    bool finite() const {
        float sum = 0;
        for (const auto& stokes : polarized)
            for (const float s : stokes.s) sum += s;
        for (const float power : unpolarized) sum += power;
        return std::isfinite(sum);
    }
    /// Power per field and band, as a tree over position and direction files it: the Stokes components in the frame
    /// turned by `turn`, then the unpolarized world.
    void gloss_fields(const FrameRotation<float>& turn, float factor, std::span<float> weights) const {
        for (std::size_t b = 0; b < bands; ++b) {
            const Stokes<float, components> turned = rotate(turn, polarized[b]);
            for (int j = 0; j < components; ++j) weights[static_cast<std::size_t>(j * bands) + b] = factor * turned[j];
            if constexpr (two_worlds)
                weights[static_cast<std::size_t>(components * bands) + b] = factor * unpolarized[b];
        }
    }
    void scale_band(std::size_t band, float factor) {
        polarized[band] = factor * polarized[band];
        if constexpr (two_worlds) unpolarized[band] *= factor;
    }
    void scale(float factor) {
        for (auto& stokes : polarized) stokes = factor * stokes;
        for (float& power : unpolarized) power *= factor;
    }
};

}  // namespace brewster
