#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"

namespace brewster {
namespace {

Image radiance(const std::vector<float>& red) {
    Image image(static_cast<int>(red.size()), 1);
    for (int band = 0; band < 3; ++band) image.add_channel(stokes_channel(0, band)) = red;
    return image;
}

const BandDifference& red(const PictureDifference& difference) {
    return (*difference.components[0])[0];
}

TEST(Compare, EqualPicturesDoNotDiffer) {
    const Image image = radiance({1, 2, 3});
    const PictureDifference difference = compare(image, image);
    EXPECT_EQ(difference.pixels, 3u);
    EXPECT_EQ(red(difference).rmse, 0);
    EXPECT_EQ(red(difference).relative_rmse, 0);
    EXPECT_EQ(red(difference).bias, 0);
    EXPECT_FALSE(red(difference).bias_standard_error);
    EXPECT_FALSE(difference.components[1]);
}

// b = (1, 3): mean 2, e = 0.02. a - b = (0.5, -0.3).
TEST(Compare, MetricsFollowTheirDefinitions) {
    const PictureDifference difference = compare(radiance({1.5f, 2.7f}), radiance({1, 3}));
    EXPECT_NEAR(red(difference).rmse, std::sqrt((0.25 + 0.09) / 2), 1e-7);
    EXPECT_NEAR(red(difference).relative_rmse, std::sqrt((0.25 / 1.0004 + 0.09 / 9.0004) / 2), 1e-7);
    EXPECT_NEAR(red(difference).bias, 0.1, 1e-7);
    EXPECT_NEAR(red(difference).mean_a, 2.1, 1e-7);
    EXPECT_NEAR(red(difference).mean_b, 2.0, 1e-7);
}

// A black reference pixel is judged against 1 % of the mean: here e = 0.01, so a = 0.01 there is an error of 100 %.
TEST(Compare, DarkPixelsAreJudgedAgainstOnePercentOfTheMean) {
    EXPECT_NEAR(red(compare(radiance({0.01f, 2}), radiance({0, 2}))).relative_rmse, std::sqrt(0.5), 1e-6);
}

TEST(Compare, EpsilonIsAShareOfTheMean) {
    const PictureDifference difference = compare(radiance({0.01f, 2}), radiance({0, 2}), {}, 0.1);
    EXPECT_NEAR(red(difference).relative_rmse, 0.1 * std::sqrt(0.5), 1e-6);
}

// Relative differences 0.00, 0.01, .., 0.99 (but for e): 50 % of them end with 0.49.
TEST(Compare, PercentilesOfRelativeDifferences) {
    std::vector<float> a(100), b(100, 1.0f);
    for (std::size_t i = 0; i < 100; ++i) a[(i * 37) % 100] = 1.0f + 0.01f * static_cast<float>(i);
    const BandDifference band = red(compare(radiance(a), radiance(b)));
    const std::array<double, 4> expected = {0.49, 0.89, 0.98, 0.99};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(band.percentiles[k], expected[k], 1e-4);
}

TEST(Compare, MaskSelectsTheRegion) {
    const std::vector<std::uint8_t> mask = {0, 1, 1};
    const PictureDifference difference = compare(radiance({100, 2, 3}), radiance({1, 2, 4}), mask);
    EXPECT_EQ(difference.pixels, 2u);
    EXPECT_NEAR(red(difference).bias, -0.5, 1e-12);
}

TEST(Compare, BiasErrorComesFromTheVariancesOfBoth) {
    Image a = radiance({1, 1, 1, 1}), b = radiance({1, 1, 1, 1});
    a.add_channel(variance_channel(0, 0)).assign(4, 0.03f);
    EXPECT_NEAR(*red(compare(a, b)).bias_standard_error, std::sqrt(4 * 0.03) / 4, 1e-8);
    b.add_channel(variance_channel(0, 0)).assign(4, 0.01f);
    EXPECT_NEAR(*red(compare(a, b)).bias_standard_error, std::sqrt(4 * 0.04) / 4, 1e-8);
}

TEST(Compare, CountsPixelsWithinTheErrorsOfBoth) {
    Image a = radiance({1, 1, 1, 1}), b = radiance({1, 1.3f, 1.5f, 1.7f});
    EXPECT_FALSE(red(compare(a, b)).within);
    a.add_channel(variance_channel(0, 0)).assign(4, 0.03f);
    b.add_channel(variance_channel(0, 0)).assign(4, 0.01f);
    EXPECT_EQ(red(compare(a, b)).within, (std::array{0.25, 0.5, 0.75}));
}

TEST(Compare, RadianceMayStandInPlainChannels) {
    Image plain(2, 1);
    for (const char* name : {"R", "G", "B"}) plain.add_channel(name) = {1, 3};
    EXPECT_NEAR(red(compare(radiance({1.5f, 2.7f}), plain)).bias, 0.1, 1e-7);
}

TEST(Compare, EachStokesComponentBothHold) {
    Image a = radiance({1, 2}), b = radiance({1, 2});
    for (int band = 0; band < 3; ++band) {
        a.add_channel(stokes_channel(2, band)) = {0.2f, -0.1f};
        b.add_channel(stokes_channel(2, band)) = {0.1f, -0.1f};
        a.add_channel(stokes_channel(3, band));
    }
    const PictureDifference difference = compare(a, b);
    EXPECT_FALSE(difference.components[1]);
    ASSERT_TRUE(difference.components[2]);
    EXPECT_NEAR((*difference.components[2])[1].bias, 0.05, 1e-7);
    EXPECT_FALSE(difference.components[3]);
}

// a = truth = 1, b = truth + noise of standard deviation s = 0.03. What is left after the subtraction has the
// expectation 6 s^4 = 5e-6 (b^2 in the divisor) and the standard deviation s^2 sqrt(2/n) = 9e-6, n = 20000: its root
// stays below sqrt(7e-5) < 0.009 but for one seed in 1e9. Negative controls: without the variance the pictures are 0.03
// apart, and an error of 0.2 stays (0.2 sqrt(1 + 23 s^2) = 0.202).
TEST(Compare, NoiseOfTheReferenceIsSubtracted) {
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0f, 0.03f);
    std::vector<float> noisy(20000);
    for (float& x : noisy) x = 1.0f + noise(random);
    Image b = radiance(noisy);
    EXPECT_GT(red(compare(radiance(std::vector<float>(20000, 1.0f)), b)).relative_rmse, 0.027);
    b.add_channel(variance_channel(0, 0)).assign(20000, 0.0009f);
    EXPECT_LT(red(compare(radiance(std::vector<float>(20000, 1.0f)), b)).relative_rmse, 0.009);
    EXPECT_NEAR(red(compare(radiance(std::vector<float>(20000, 1.2f)), b)).relative_rmse, 0.202, 0.003);
}

// Truths 1 and 1.02, noise of .03 and .04: (.02^2 +- s sqrt(2/n)), s = .05^2 + .02^2 = .0029, so +- 2.9e-5, 4 of which
// move the root .02 by less than .003. Without noise of its own the difference would be .054.
TEST(Compare, NoiseOfBothIsLeftOut) {
    std::mt19937 random(8);
    std::normal_distribution<float> noise;
    std::vector<float> a(20000), b(20000);
    for (float& x : a) x = 1.02f + 0.03f * noise(random);
    for (float& x : b) x = 1.0f + 0.04f * noise(random);
    Image first = radiance(a), second = radiance(b);
    first.add_channel(variance_channel(0, 0)).assign(20000, 0.0009f);
    second.add_channel(variance_channel(0, 0)).assign(20000, 0.0016f);
    EXPECT_NEAR(red(compare(first, second)).rmse, 0.0539, 0.001);
    EXPECT_NEAR(red(compare(first, second)).rmse_beyond_noise, 0.02, 0.003);
}

TEST(Compare, SaysWhatCannotBeCompared) {
    EXPECT_THROW(compare(radiance({1, 2}), radiance({1, 2, 3})), Error);
    EXPECT_THROW(compare(radiance({1, 2}), Image(2, 1)), Error);
    EXPECT_THROW(compare(radiance({1, 2}), radiance({1, 2}), std::vector<std::uint8_t>{0, 0}), Error);
    EXPECT_THROW(compare(radiance({1, std::numeric_limits<float>::quiet_NaN()}), radiance({1, 2})), Error);
}

}  // namespace
}  // namespace brewster
