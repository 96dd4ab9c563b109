#include "image/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace brewster {
namespace {

Image four_pixels() {
    Image image(2, 2);
    for (int band = 0; band < 3; ++band) {
        image.add_channel(stokes_channel(0, band)) = {1, 3, 5, 7};
        image.add_channel(stokes_channel(1, band)) = {0.5f, -0.5f, 0, 3};
        image.add_channel(stokes_channel(2, band)) = {0.5f, 1.5f, 1, 3};
        image.add_channel(stokes_channel(3, band)) = {0, -1, -1, 0};
        image.add_channel(variance_channel(0, band)) = {4, 4, 4, 4};
    }
    return image;
}

TEST(Statistics, MeansComeBeforeDegreesAndAngles) {
    const std::vector<std::uint8_t> mask = {1, 1, 0, 0};
    const PictureStatistics of = statistics(four_pixels(), mask);
    EXPECT_EQ(of.pixels, 2u);
    const BandStatistics& red = of.bands[0];
    EXPECT_EQ(red.mean, (std::array<double, 4>{2, 0, 1, -0.5}));
    EXPECT_NEAR(red.standard_error[0], std::sqrt(8.0) / 2, 1e-12);
    EXPECT_EQ(red.dolp, 0.5);
    EXPECT_EQ(red.docp, 0.25);
    EXPECT_NEAR(red.dop, std::sqrt(1.25) / 2, 1e-12);
    EXPECT_EQ(red.aolp, 45);
    EXPECT_EQ(statistics(four_pixels()).bands[2].mean[0], 4);
}

TEST(Statistics, PlainPicturesAndEmptyRegions) {
    Image plain(1, 1);
    for (const char* band : {"R", "G", "B"}) plain.add_channel(band) = {2};
    EXPECT_EQ(statistics(plain).bands[1].mean[0], 2);
    EXPECT_FALSE(statistics(plain).bands[1].aolp);
    const std::vector<std::uint8_t> nothing(4, 0);
    EXPECT_THROW(statistics(four_pixels(), nothing), Error);
    EXPECT_THROW(statistics(Image(2, 2)), Error);
}

}  // namespace
}  // namespace brewster
