#include "gather/pixel_sums.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brewster {
namespace {

TEST(SharedOutDraws, FollowTheErrorInPowersOfTwo) {
    std::vector<float> importance;
    for (int k = 0; k < 1000; ++k) importance.push_back(std::exp2(0.02f * static_cast<float>(k)));
    const auto draws = shared_out_draws(importance, 16, 256);
    double sum = 0;
    for (std::size_t k = 0; k < draws.size(); ++k) {
        EXPECT_GE(draws[k], 16u);
        EXPECT_EQ(draws[k] & (draws[k] - 1), 0u);
        if (k > 0) {
            EXPECT_GE(draws[k], draws[k - 1]);
        }
        sum += draws[k];
    }
    EXPECT_LE(sum / 1000, 256);
    EXPECT_GT(sum / 1000, 230);
    // 2^10 times the squared error: 2^4.5 times the draws, before rounding.
    EXPECT_NEAR(std::log2(draws[900] / static_cast<double>(draws[400])), 4.5, 1);
}

TEST(SharedOutDraws, NothingKnownIsSharedEvenly) {
    for (const std::uint32_t draws : shared_out_draws(std::vector<float>(10, 0.0f), 16, 64)) EXPECT_EQ(draws, 64u);
}

/// What a pixel is given owes nothing to its own draws.
TEST(ImportanceOf, APixelsOwnErrorDoesNotCount) {
    std::vector<PixelSum> pixels(9 * 9);
    for (PixelSum& pixel : pixels) {
        pixel.draws = 16;
        pixel.sums[0][0] = 8;
        pixel.sums[1][0] = 9;
    }
    const auto before = importance_of(pixels, 9, 9);
    pixels[40].sums[0][0] = 80;
    const auto after = importance_of(pixels, 9, 9);
    EXPECT_NEAR(after[40], before[40], 1e-4f * before[40]);
    EXPECT_GT(after[41], 2 * before[41]);
}

/// Two replicas that agree though their draws scatter: evenly spread draws err less than their scatter says.
TEST(PictureOf, ReplicasTellTheError) {
    const auto variance_of = [](float first, float second) {
        std::vector<PixelSum> pixels(49);
        for (PixelSum& pixel : pixels) {
            pixel.draws = 8;
            pixel.sums[0][0] = first;
            pixel.sums[1][0] = second;
            pixel.squares[0] = 8 * 1.25f + 2;  // draws scatter by about one
            pixel.error[0] = 8 * 0.25f;        // each draw from bins known to .25
        }
        return picture_of(pixels, 7, 7).variance_of(Plane::s0)[24].x;
    };
    EXPECT_NEAR(variance_of(4, 4), 0.0625f, 1e-6f);
    EXPECT_NEAR(variance_of(4.4f, 3.6f), 0.0625f + 0.01f, 1e-4f);  // ((4.4 - 3.6)/4)^2/4
}

/// 7 x 7 pixels of radiance 1 whose replicas differ by 2 spread, so that their draws err by spread; the bins alone are off by
/// `apart` and say `stated`.
std::vector<PixelSum> pixels_beside_bins(float spread, float apart, float stated) {
    std::vector<PixelSum> pixels(49);
    for (PixelSum& pixel : pixels) {
        pixel.draws = 8;
        pixel.alone_draws = 4;
        pixel.alone_known = true;
        for (std::size_t value = 0; value < plane_values; ++value) {
            pixel.sums[0][value] = 4 * (1 + spread);
            pixel.sums[1][value] = 4 * (1 - spread);
            pixel.squares[value] = 8 * 1.25f;
            pixel.alone[value] = 4 * (1 + apart);
        }
        pixel.alone_error.fill(4 * stated);
    }
    return pixels;
}

/// Bins as good as they say get what leaves the least error; those that are off by more than the draws do not.
TEST(SharesOfBins, FollowWhatBothErrBy) {
    const auto share = [](float spread, float apart, float stated) {
        return shares_of_bins(pixels_beside_bins(spread, apart, stated), 7, 7)[24].share;
    };
    EXPECT_NEAR(share(0.3f, 0.3f, 0.1f), 0.9f, 1e-4f);    // .09 / (.09 + .01)
    EXPECT_NEAR(share(0.1f, 0.1f, 0.3f), 0.1f, 1e-4f);    // .01 / (.01 + .09)
    EXPECT_NEAR(share(0.1f, 0.5f, 0.01f), 0.04f, 1e-4f);  // .01 / .25: what is stated is not believed
    EXPECT_EQ(share(0, 0.5f, 0.1f), 0);
}

TEST(SharesOfBins, APixelsOwnDrawsDoNotCount) {
    std::vector<PixelSum> pixels = pixels_beside_bins(0.3f, 0.3f, 0.1f);
    const float before = shares_of_bins(pixels, 7, 7)[24].share;
    pixels[24].sums[0].fill(100);
    EXPECT_NEAR(shares_of_bins(pixels, 7, 7)[24].share, before, 1e-3f);
    EXPECT_GT(shares_of_bins(pixels, 7, 7)[25].share, 0.99f);  // a neighbour takes the draws to scatter
}

TEST(SharesOfBins, NoneWhereNoDrawMetGlossOrOneDrawTellsNoError) {
    std::vector<PixelSum> pixels = pixels_beside_bins(0.3f, 0.3f, 0.1f);
    pixels[3].alone_known = false;
    pixels[4].draws = 1;
    const std::vector<BinsShare> shares = shares_of_bins(pixels, 7, 7);
    EXPECT_EQ(shares[3].share, 0);
    EXPECT_EQ(shares[4].share, 0);
    EXPECT_GT(shares[5].share, 0.5f);
}

/// Light and variance of the mixture: .1 of the draws' 1 and .9 of the bins' 1.3; .01 of .09 and .81 of .01.
TEST(PictureOf, TakesItsShareFromTheBinsAlone) {
    const StokesPicture picture = picture_of(pixels_beside_bins(0.3f, 0.3f, 0.1f), 7, 7);
    EXPECT_NEAR(picture.of(Plane::s0)[24].x, 1.27f, 1e-4f);
    EXPECT_NEAR(picture.of(Plane::s2)[24].y, 1.27f, 1e-4f);
    EXPECT_NEAR(picture.variance_of(Plane::s0)[24].x, 0.01f * 0.09f + 0.81f * 0.01f, 1e-4f);
    EXPECT_NEAR(error_of(pixels_beside_bins(0.3f, 0.3f, 0.1f)).draws, 0.09, 1e-5);  // what more draws mend
}

/// Two pixels of radiance 1 and 2 in every band: relative squares ((4.4 - 3.6)/4)^2/4 and a quarter of that, halved by the
/// mean; likewise bins known to .25.
TEST(ErrorOf, IsRelativeToEachPixel) {
    std::vector<PixelSum> pixels(2);
    for (std::size_t p = 0; p < 2; ++p) {
        const float scale = p == 0 ? 1.0f : 2.0f;
        pixels[p].draws = 8;
        for (std::size_t band = 0; band < band_count; ++band) {
            pixels[p].sums[0][band] = 4 * scale + 0.4f;
            pixels[p].sums[1][band] = 4 * scale - 0.4f;
            pixels[p].error[band] = 8 * 0.25f;
        }
    }
    const PictureError error = error_of(pixels);
    EXPECT_NEAR(error.draws, 0.01 * (1 + 0.25) / 2, 1e-5);
    EXPECT_NEAR(error.bins, 0.0625 * (1 + 0.25) / 2, 1e-4);
    EXPECT_EQ(error_of(std::vector<PixelSum>(4)).draws, 0);
}

}  // namespace
}  // namespace brewster
