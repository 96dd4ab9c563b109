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

}  // namespace
}  // namespace brewster
