#include "optics/inverted_slopes.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

/// The share of the density (1 + x/h) exp(-x^2), x > -h, above x.
double share_above(double h, double x) {
    const double gaussian = std::exp(-x * x) / (2 * std::sqrt(pi));
    return (h * std::erfc(x) / 2 + gaussian) / (h * std::erfc(-h) / 2 + std::exp(-h * h) / (2 * std::sqrt(pi)));
}

/// The largest error of the share that `slope(h, u)` leaves, over even numbers and the sixteen next to both ends.
template <class Slope>
double worst_error(double h, const Slope& slope) {
    double worst = 0;
    const auto look = [&](float u) {
        const double x = static_cast<double>(slope(static_cast<float>(h), u));
        EXPECT_GE(x, -h) << h << ' ' << u;
        worst = std::max(worst, std::abs(share_above(h, x) - static_cast<double>(u)));
    };
    constexpr int count = 5000;
    for (int k = 0; k < count; ++k) look((static_cast<float>(k) + 0.5f) / count);
    for (int k = 1; k <= 16; ++k) {
        look(static_cast<float>(k) * 0x1p-24f);
        look(1 - static_cast<float>(k) * 0x1p-24f);
    }
    return worst;
}

TEST(InvertedSlopes, HaveTheShareAboveThemThatWasAskedFor) {
    for (double h = 1e-4; h < 1e9; h *= 1.07) EXPECT_LT(worst_error(h, inverted_slope<float>), 2e-5) << h;
}

/// A Gaussian alone, which is right for h without bound, is not for h = 2.
TEST(InvertedSlopes, NegativeControl) {
    const auto gaussian = [](float h, float u) { return std::max(inverted_erfc(u), -h); };
    EXPECT_LT(worst_error(1e6, gaussian), 2e-6);
    EXPECT_GT(worst_error(2, gaussian), 0.05);
}

TEST(InvertedSlopes, AcrossAreThoseOfAGaussian) {
    for (int k = 1; k < (1 << 16); ++k) {
        const float u = static_cast<float>(k) * 0x1p-16f;
        ASSERT_NEAR(std::erfc(static_cast<double>(inverted_erfc(u))) / 2, static_cast<double>(u), 1e-6);
    }
    EXPECT_GT(inverted_erfc(0x1p-25f), 3.7f);
}

/// What sequences of evenly spread numbers need: no facet is turned over between near numbers.
TEST(InvertedSlopes, NearNumbersGiveNearSlopes) {
    for (const float h : {0.03f, 0.4f, 0.99f, 1.01f, 2.0f, 3.19f, 3.21f, 40.0f}) {
        float before = inverted_slope(h, 0.0005f);
        for (int k = 1; k < 1000; ++k) {
            const float x = inverted_slope(h, (static_cast<float>(k) + 0.5f) / 1000);
            ASSERT_LT(x, before) << h << ' ' << k;
            ASSERT_GT(x, before - 0.5f) << h << ' ' << k;
            before = x;
        }
    }
}

}  // namespace
}  // namespace brewster
