#include "image/compare_polarization.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"

namespace brewster {
namespace {

struct Pixel {
    double s0, dolp, aolp;  // aolp in degrees
};

Image picture(const std::vector<Pixel>& pixels) {
    Image image(static_cast<int>(pixels.size()), 1);
    for (int band = 0; band < 3; ++band) {
        for (int component = 0; component < 3; ++component) image.add_channel(stokes_channel(component, band));
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const auto [s0, dolp, aolp] = pixels[i];
            image.channel(stokes_channel(0, band))[i] = static_cast<float>(s0);
            image.channel(stokes_channel(1, band))[i] = static_cast<float>(s0 * dolp * std::cos(radians(2 * aolp)));
            image.channel(stokes_channel(2, band))[i] = static_cast<float>(s0 * dolp * std::sin(radians(2 * aolp)));
        }
    }
    return image;
}

BandPolarization green(const Image& a, const Image& b, std::span<const std::uint8_t> mask = {}) {
    return (*compare_polarization(a, b, mask))[1];
}

TEST(ComparePolarization, NeedsLinearStokesInBoth) {
    Image radiance(1, 1);
    for (int band = 0; band < 3; ++band) radiance.add_channel(stokes_channel(0, band));
    EXPECT_FALSE(compare_polarization(radiance, picture({{1, 0.5, 0}})));
    EXPECT_FALSE(compare_polarization(picture({{1, 0.5, 0}}), radiance));
}

TEST(ComparePolarization, DegreesDifferPlainly) {
    const BandPolarization band =
        green(picture({{1, 0.5, 0}, {2, 0.3, 10}, {0, 0, 0}}), picture({{3, 0.4, 0}, {1, 0.5, 10}, {1, 0.9, 0}}));
    EXPECT_NEAR(band.mean_dolp_a, 0.4, 1e-6);  // the dark pixel has no degree
    EXPECT_NEAR(band.mean_dolp_b, 0.45, 1e-6);
    EXPECT_NEAR(band.dolp_bias, -0.05, 1e-6);
    EXPECT_NEAR(band.dolp_rmse, std::sqrt((0.01 + 0.04) / 2), 1e-6);
    EXPECT_NEAR(band.aolp_rmse, 0, 1e-4);
}

// 88 and -88 degrees are four apart, not 176.
TEST(ComparePolarization, AnglesDifferAroundTheHalfCircle) {
    const BandPolarization band = green(picture({{1, 0.5, 88}, {1, 0.2, -10}}), picture({{2, 0.5, -88}, {1, 0.5, -8}}));
    EXPECT_EQ(band.aolp_pixels, 2u);
    EXPECT_NEAR(band.aolp_rmse, std::sqrt((16.0 + 4.0) / 2), 1e-3);
    EXPECT_NEAR(band.aolp_bias, -3, 1e-3);
}

TEST(ComparePolarization, WhatIsHardlyPolarizedHasNoAngle) {
    EXPECT_EQ(green(picture({{1, 0.019, 0}, {1, 0.5, 0}}), picture({{1, 0.5, 30}, {1, 0.021, 0}})).aolp_pixels, 1u);
    Image noisy = picture({{1, 0.1, 0}, {1, 0.1, 0}});
    noisy.add_channel(variance_channel(1, 1)) = {0.002f, 0.001f};
    noisy.add_channel(variance_channel(2, 1)) = {0.002f, 0.001f};
    EXPECT_EQ(green(noisy, picture({{1, 0.5, 0}, {1, 0.5, 0}})).aolp_pixels, 1u);  // 3 sigma: 0.134 and 0.095
}

TEST(ComparePolarization, MaskSelects) {
    const std::vector<std::uint8_t> mask = {0, 1};
    EXPECT_NEAR(green(picture({{1, 0.9, 0}, {1, 0.5, 0}}), picture({{1, 0.1, 80}, {1, 0.5, 5}}), mask).aolp_rmse, 5,
                1e-4);
}

}  // namespace
}  // namespace brewster
