#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "image/image.h"

namespace brewster {

/// Means of one band over a region.
struct BandStatistics {
    std::array<double, 4> mean{};            ///< of S0 .. S3; 0 for components that the picture has not
    std::array<double, 4> standard_error{};  ///< of these, pixels taken as independent; 0 without variances
    /// Of the mean light, not the mean of the pixels': noise averages out first.
    double dop = 0, dolp = 0, docp = 0;
    std::optional<double> aolp;  ///< degrees in (-90, 90]; none where the mean is not linearly polarized
};

struct PictureStatistics {
    std::size_t pixels = 0;
    std::array<BandStatistics, 3> bands;
};

/// Of a picture with channels S0.R .., or R G B. `mask` selects pixels by non-zero, empty takes all. Throws Error for an
/// empty region or missing channels.
PictureStatistics statistics(const Image& picture, std::span<const std::uint8_t> mask = {});

}  // namespace brewster
