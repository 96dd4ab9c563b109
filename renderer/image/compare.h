#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "image/compare_polarization.h"
#include "image/image.h"

namespace brewster {

inline constexpr std::array<int, 4> difference_percentiles = {50, 90, 99, 100};
inline constexpr double default_epsilon = 0.01;

/// How one Stokes component of one band of a picture `a` differs from a reference `b`.
struct BandDifference {
    double mean_a = 0, mean_b = 0;
    double rmse = 0;  ///< sqrt(mean((a - b)^2)), in the picture's unit
    /// The same with the variances of both pictures subtracted (one that has none counts as exact): what they really
    /// differ in. A negative rest counts as 0.
    double rmse_beyond_noise = 0;
    /// sqrt(mean(((a - b)^2 - variance of b) / (b^2 + e^2))), e = epsilon times b's mean S0 in the region.
    double relative_rmse = 0;
    double bias = 0;  ///< mean(a - b)
    /// Of |a - b| / sqrt(b^2 + e^2), noise included: what 50, 90, 99 and 100 % of the pixels stay below or at.
    std::array<double, 4> percentiles{};
    /// Of the bias, from the pixel variances of both pictures (one that has none counts as exact); none when neither
    /// has them. Pixels count as independent: where bins join neighbours, the true error is larger.
    std::optional<double> bias_standard_error;
    /// Share of the pixels where |a - b| is within 1, 2 and 3 standard errors, of both pictures together: 68, 95 and
    /// 99.7 % where errors are normal and their bars honest. None when neither has variances.
    std::optional<std::array<double, 3>> within;
};

struct PictureDifference {
    std::size_t pixels = 0;  ///< compared
    /// [component][band]; S0 is always there, S1 to S3 when both pictures hold them.
    std::array<std::optional<std::array<BandDifference, 3>>, 4> components;
    std::optional<std::array<BandPolarization, 3>> polarization;  ///< when both pictures hold S1 and S2
};

/// Compares two pictures of equal size. S0 is read from S0.R S0.G S0.B, or from R G B where those are missing; the
/// variances V0.R .. V3.B of `b` are subtracted from its relative rmse where they exist (a negative rest counts as 0).
/// `mask`, one byte a pixel, selects pixels by non-zero; empty takes all.
/// `epsilon`: of b's mean S0, below which a pixel's relative error is measured against that instead; > 0.
/// Throws Error for unequal sizes, missing channels, an empty region, or a pixel that is not a finite number.
PictureDifference compare(const Image& a, const Image& b, std::span<const std::uint8_t> mask = {},
                          double epsilon = default_epsilon);

}  // namespace brewster
