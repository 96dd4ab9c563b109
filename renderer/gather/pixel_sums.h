#pragma once
#include <cstdint>
#include <vector>

#include "gather/eye_level.h"
#include "gather/eye_tracer.h"
#include "image/stokes_picture.h"

namespace brewster {

inline constexpr std::size_t plane_values = plane_count * band_count;
inline constexpr int tile_pixels = 16;  ///< along a side of the tiles that pictures are drawn and shown in

/// What the draws of one pixel add up to. They come in two replicas, sequences of their own that take turns, so that
/// their difference tells what evenly spread draws really err by.
struct PixelSum {
    std::uint32_t draws = 0;
    std::array<std::array<float, plane_values>, 2> sums{};                          ///< per replica; plane * 3 + band
    std::array<float, plane_values + band_count> squares{};                         ///< and those of s0 - unpolarized
    std::array<float, band_count> error{}, polarized_error{}, unpolarized_error{};  ///< that the bins lend
    float coarse = 0;  ///< band mean of what came from bins of gloss
    /// What the bins alone say, of so many of the first draws; nothing where none of these met rough gloss first.
    std::uint32_t alone_draws = 0;
    bool alone_known = false;
    std::array<float, plane_values> alone{};
    std::array<float, band_count> alone_error{}, alone_polarized_error{};  ///< of s0; of each of s1, s2, s3

    float mean(std::size_t value) const { return (sums[0][value] + sums[1][value]) / static_cast<float>(draws); }
    float alone_mean(std::size_t value) const { return alone[value] / static_cast<float>(alone_draws); }
};

/// So many of a pixel's first draws read the bins alone, too.
inline constexpr std::uint32_t draws_of_bins_alone = 4;

/// Adds draws [first, first + count) of a batch to a pixel, whose next draw is the first of them. `components`: of what
/// was seen; 1: both worlds are the same.
void add_draws(const LevelLight& seen, const BinsAlone& alone, int components, std::size_t first, std::size_t count,
               PixelSum& pixel);

/// How much of each pixel's light is taken from the bins alone, and by how much their squared error exceeds the draws'.
struct BinsShare {
    float share = 0;      ///< 0 .. 1
    float ratio = 0;      ///< squared error of bins alone over that of the draws
    float polarized = 0;  ///< squared error of one of s1, s2, s3 of bins alone, as they differ from the draws
};

/// The share that leaves the least squared error, draws^2 / (draws^2 + bins^2). The draws' error is the replicas'; that
/// of bins alone what they state, or by how much more than by the draws' error the two differ, if that is more: so bins
/// count only where they are as good as they say. Both are pooled over 7 x 7 pixels of one tile without the pixel itself,
/// so that the share owes nothing to the pixel's own draws, and is the same in the picture as in its tile.
std::vector<BinsShare> shares_of_bins(const std::vector<PixelSum>& pixels, int width, int height);

/// The mean of the draws with its variance: what single draws scatter by, times how much less the two replicas differ
/// than independent draws would, which is pooled over 7 x 7 pixels; and the variance of the bins. Pixels with one draw
/// are known to within their own value. Where few draws of gloss err by more than bins alone, these have their share.
StokesPicture picture_of(const std::vector<PixelSum>& pixels, int width, int height);

/// What draws err by without the bins' share: what more draws mend. Squared relative errors of the band-mean radiance
/// (polarized world), mean over the pixels; radiance counts as 1 % of the picture's mean at least.
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
