#pragma once
#include <cstdint>
#include <vector>

#include "gather/eye_level.h"
#include "image/stokes_picture.h"

namespace brewster {

inline constexpr std::size_t plane_values = plane_count * band_count;

/// What the draws of one pixel add up to. They come in two replicas, sequences of their own that take turns, so that
/// their difference tells what evenly spread draws really err by.
struct PixelSum {
    std::uint32_t draws = 0;
    std::array<std::array<float, plane_values>, 2> sums{};                          ///< per replica; plane * 3 + band
    std::array<float, plane_values + band_count> squares{};                         ///< and those of s0 - unpolarized
    std::array<float, band_count> error{}, polarized_error{}, unpolarized_error{};  ///< that the bins lend
    float coarse = 0;  ///< band mean of what came from bins of gloss

    float mean(std::size_t value) const { return (sums[0][value] + sums[1][value]) / static_cast<float>(draws); }
};

/// Adds draws [first, first + count) of a batch to a pixel, whose next draw is the first of them. `components`: of what
/// was seen; 1: both worlds are the same.
void add_draws(const LevelLight& seen, int components, std::size_t first, std::size_t count, PixelSum& pixel);

/// The mean of the draws with its variance: what single draws scatter by, times how much less the two replicas differ
/// than independent draws would, which is pooled over 7 x 7 pixels; and the variance of the bins. Pixels with one draw
/// are known to within their own value.
StokesPicture picture_of(const std::vector<PixelSum>& pixels, int width, int height);

/// Squared relative errors of the band-mean radiance (polarized world), mean over the pixels; radiance counts as 1 % of the
/// picture's mean at least.
struct PictureError {
    double draws = 0;  ///< as the replicas differ
    double bins = 0;   ///< that the bins lend
};
PictureError error_of(const std::vector<PixelSum>& pixels);

/// How much the draws' error counts at each pixel: the squared difference of the replicas' band-mean s0 and unpolarized
/// radiance relative to the radiance, pooled over 7 x 7 pixels without the pixel itself. So draws that a pixel is given by
/// it owe nothing to the pixel's own, and its mean stays unbiased.
std::vector<float> importance_of(const std::vector<PixelSum>& pixels, int width, int height);

/// Draws for each pixel: powers of two, at least `least`, on the mean `mean_draws` or a little less, in proportion to
/// importance^.45 (the error's .9th power).
std::vector<std::uint32_t> shared_out_draws(const std::vector<float>& importance, std::uint32_t least,
                                            double mean_draws);

}  // namespace brewster
