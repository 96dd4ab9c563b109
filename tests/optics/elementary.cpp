#include "base/elementary.h"

#include <gtest/gtest.h>

#include <cstdio>

/// The float functions against the C library's double. They stand with optics because only optics states the need.
namespace brewster {
namespace {

template <class Value, class Truth>
double worst_relative(double low, double high, double step, const char* name, Value value, Truth truth) {
    double worst = 0, at = 0;
    for (double x = low; x < high; x += step) {
        const float xf = static_cast<float>(x);
        const double expected = truth(static_cast<double>(xf));
        const double error = std::abs(static_cast<double>(value(xf)) - expected) / std::abs(expected);
        if (error > worst) worst = error, at = xf;
    }
    std::printf("float  %-6s on [%g, %g): relative %.2e at %.9g\n", name, low, high, worst, at);
    return worst;
}

TEST(ElementaryFloat, Exp) {
    EXPECT_LE(worst_relative(
                  -87.3, 88.3, 1e-4, "exp", [](float x) { return exp(x); }, [](double x) { return std::exp(x); }),
              1.2e-7);
    EXPECT_EQ(exp(-100.0f), 0);
    EXPECT_EQ(exp(-1e30f), 0);
    EXPECT_EQ(exp(0.0f), 1);
    EXPECT_TRUE(std::isfinite(exp(1e30f)));
}

TEST(ElementaryFloat, Log) {
    const auto value = [](float x) { return log(x); };
    const auto truth = [](double x) { return std::log(x); };
    EXPECT_LE(worst_relative(1e-4, 3, 1e-6, "log", value, truth), 1.5e-7);
    EXPECT_LE(worst_relative(3, 1e6, 0.37, "log", value, truth), 1.5e-7);
    for (float x = 1e-43f; x < 1; x *= 1.37f) EXPECT_NEAR(log(x) / std::log(static_cast<double>(x)), 1, 1.5e-7) << x;
    EXPECT_NEAR(log(0.0f), -103.97f, 0.01f);
}

TEST(ElementaryFloat, ErfAndErfc) {
    EXPECT_LE(worst_relative(
                  1e-6, 6, 1e-5, "erf", [](float x) { return erf(x); }, [](double x) { return std::erf(x); }),
              4e-7);
    EXPECT_LE(worst_relative(
                  0, 3, 1e-5, "erfc", [](float x) { return erfc(x); }, [](double x) { return std::erfc(x); }),
              1e-6);
    for (float x = -5; x < 0; x += 1e-4f) {
        ASSERT_NEAR(erfc(x), std::erfc(static_cast<double>(x)), 4e-7);
        ASSERT_NEAR(erf(x), std::erf(static_cast<double>(x)), 4e-7);
    }
    EXPECT_EQ(erf(0.0f), 0);
}

TEST(ElementaryFloat, Erfcx) {
    const auto truth = [](double x) { return std::exp(x * x) * std::erfc(x); };
    EXPECT_LE(worst_relative(
                  0, 20, 1e-5, "erfcx", [](float x) { return erfcx(x); }, truth),
              4e-7);
}

TEST(ElementaryFloat, ArcCosineAndOneMinusExp) {
    double worst = 0;
    for (float x = -1; x <= 1; x += 1e-6f)
        worst = std::max(worst, std::abs(acos(x) - std::acos(static_cast<double>(x))));
    std::printf("float  acos: absolute %.2e\n", worst);
    EXPECT_LE(worst, 6e-7);
    EXPECT_EQ(acos(1.0f), 0);
    const auto value = [](float x) { return one_minus_exp(x); };
    EXPECT_LE(worst_relative(1e-7, 1, 1e-6, "1-e^-x", value, [](double x) { return -std::expm1(-x); }), 4e-7);
}

TEST(ElementaryFloat, SineAndCosine) {
    double worst = 0;
    for (int i = 0; i < (1 << 24); i += 7) {
        const float turns = static_cast<float>(i) * 0x1p-24f;
        const SineCosine<float> value = sincos_turns(turns);
        const double angle = 2 * 3.14159265358979323846 * static_cast<double>(turns);
        worst = std::max({worst, std::abs(value.sine - std::sin(angle)), std::abs(value.cosine - std::cos(angle))});
    }
    std::printf("float  sincos_turns: absolute %.2e\n", worst);
    EXPECT_LE(worst, 2e-7);
    const SineCosine<double> quarter = sincos_turns(0.25);
    EXPECT_EQ(quarter.sine, 1);
    EXPECT_EQ(quarter.cosine, 0);
}

}  // namespace
}  // namespace brewster
