#pragma once
#include <array>

#include "base/lanes.h"
#include "optics/frame.h"
#include "optics/stokes.h"
#include "optics/vector.h"

namespace brewster {

/// Photons whose power has grown beyond this are given up as trouble; tallies hold squares up to 2^20.
inline constexpr double largest_power = 1024;

/// What photons carry, in units of photon weight: per band a Stokes vector in the frame of `axis`, and the power of the
/// same photon in the unpolarized world. With one component both worlds are the same and `unpolarized` is not used.
template <class Real, int components, int bands>
struct PhotonLight {
    static constexpr bool two_worlds = components > 1;
    static constexpr int worlds = two_worlds ? 2 : 1;
    static constexpr int fields = two_worlds ? components + 1 : 1;  ///< of a tree over position and direction
    static constexpr std::size_t numbers = static_cast<std::size_t>(fields * bands);

    std::array<Stokes<Real, components>, bands> polarized{};
    std::array<Real, two_worlds ? bands : 0> unpolarized{};
    Vector<Real> axis{Real(1), Real(0), Real(0)};  ///< unit, orthogonal to the direction

    const Real& power(int world, int band) const {
        const auto b = static_cast<std::size_t>(band);
        if constexpr (two_worlds) {
            if (world == 1) return unpolarized[b];
        }
        return polarized[b].s[0];
    }
    Real largest() const {
        Real greatest(0);
        for (int world = 0; world < worlds; ++world)
            for (int band = 0; band < bands; ++band) greatest = max(greatest, power(world, band));
        return greatest;
    }
    /// Whether every number is finite and no power is absurd.
    auto in_range() const {
        Real sum(0);
        for (const auto& stokes : polarized)
            for (const Real& s : stokes.s) sum = sum + abs(s);
        for (const Real& power : unpolarized) sum = sum + power;
        return sum < constant<Real>(largest_power);
    }
    /// Power per field and band, as a tree over position and direction files it: the Stokes components in the frame
    /// turned by `turn`, then the unpolarized world.
    std::array<Real, numbers> gloss_fields(const FrameRotation<Real>& turn, const Real& factor) const {
        std::array<Real, numbers> weights;
        for (std::size_t b = 0; b < bands; ++b) {
            const Stokes<Real, components> turned = rotate(turn, polarized[b]);
            for (int j = 0; j < components; ++j) weights[static_cast<std::size_t>(j * bands) + b] = factor * turned[j];
            if constexpr (two_worlds)
                weights[static_cast<std::size_t>(components * bands) + b] = factor * unpolarized[b];
        }
        return weights;
    }
    void scale_band(std::size_t band, const Real& factor) {
        polarized[band] = factor * polarized[band];
        if constexpr (two_worlds) unpolarized[band] = factor * unpolarized[band];
    }
    void scale(const Real& factor) {
        for (std::size_t band = 0; band < bands; ++band) scale_band(band, factor);
    }
};

template <class Real, int components, int bands>
PhotonLight<Real, components, bands> select(const auto& mask, const PhotonLight<Real, components, bands>& a,
                                            PhotonLight<Real, components, bands> b) {
    for (std::size_t band = 0; band < bands; ++band) {
        for (std::size_t j = 0; j < components; ++j)
            b.polarized[band].s[j] = select(mask, a.polarized[band].s[j], b.polarized[band].s[j]);
        if constexpr (components > 1) b.unpolarized[band] = select(mask, a.unpolarized[band], b.unpolarized[band]);
    }
    b.axis = select(mask, a.axis, b.axis);
    return b;
}

}  // namespace brewster
