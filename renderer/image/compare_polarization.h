#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "image/image.h"

namespace brewster {

/// How the linear polarization of one band differs between a picture `a` and a reference `b`. Both are read as they
/// stand: noise adds to a degree of polarization, so compare block means where pictures are noisy.
struct BandPolarization {
    double mean_dolp_a = 0, mean_dolp_b = 0;  ///< over pixels where both have light
    double dolp_rmse = 0, dolp_bias = 0;
    std::size_t aolp_pixels = 0;  ///< where both are polarized enough to have an angle
    double aolp_rmse = 0;         ///< degrees, of differences taken on the half circle, (-90, 90]
    double aolp_bias = 0;         ///< degrees: half the angle of the mean of exp(2 i difference)
};

/// An angle counts where DoLP is at least this in both pictures, and three standard errors where variances are known.
inline constexpr double least_dolp_with_angle = 0.02;

/// None unless both pictures hold S0, S1 and S2 of every band; equal sizes and finite pixels are taken for granted
/// (`compare` has checked them). `mask` as there.
std::optional<std::array<BandPolarization, 3>> compare_polarization(const Image& a, const Image& b,
                                                                    std::span<const std::uint8_t> mask = {});

}  // namespace brewster
