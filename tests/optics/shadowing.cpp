#include "optics/shadowing.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "optics/effective_roughness.h"
#include "reference_table.h"

namespace brewster {
namespace {

TEST(Shadowing, Reference) {
    const ReferenceTable table("shadowing");
    WorstErrors errors("shadowing");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double h = cotangent_over_slope(table(row, "cos_theta"), 2 * table(row, "alpha"));
        errors.relative("h", row, h, table(row, "h"));
        if (table(row, "Lambda") > 1e-300) errors.relative("Lambda", row, smith_lambda(h), table(row, "Lambda"));
        errors.relative("G1", row, smith_g1(h), table(row, "G1"));
        errors.relative("S", row, smith_s(h), table(row, "S"));
    }
    EXPECT_LE(errors.worst("h"), 1e-12);
    EXPECT_LE(errors.worst("Lambda"), 1e-10);
    EXPECT_LE(errors.worst("G1"), 1e-12);
    EXPECT_LE(errors.worst("S"), 1e-12);
}

TEST(Shadowing, WithoutTheExponentialItWouldBeTooDark) {
    // What the printed formula gives at 60 degrees, m = 0.2: S = 0.91 instead of 1.
    const double h = cotangent_over_slope(0.5, 0.2);
    const double printed = 0.5 * (1 / (std::sqrt(pi) * h) - std::erfc(h));
    EXPECT_NEAR(smith_s(h), 1, 1e-4);
    EXPECT_NEAR((1 - 0.5 * std::erfc(h)) / (1 + printed), 0.91, 5e-3);
}

TEST(Shadowing, FloatBounds) {
    double worst_g1 = 0, worst_s = 0, worst_core = 0, worst_lambda = 0, at_g1 = 0, at_lambda = 0;
    for (double exponent = -12; exponent < 1.2; exponent += 2e-6 * 7) {
        const float h = static_cast<float>(std::pow(10.0, exponent));
        const double hd = h;
        const double g1 = std::abs(smith_g1(h) - smith_g1(hd)), s = std::abs(smith_s(h) - smith_s(hd));
        if (g1 > worst_g1) worst_g1 = g1, at_g1 = hd;
        worst_s = std::max(worst_s, s);
        const double truth = smith_lambda(hd);
        if (truth < 2e-38) continue;
        const double lambda = std::abs(smith_lambda(h) / truth - 1);
        if (hd < 1) worst_core = std::max(worst_core, lambda);
        if (lambda > worst_lambda) worst_lambda = lambda, at_lambda = hd;
        ASSERT_TRUE(smith_g1(h) >= 0 && smith_g1(h) <= 1);
    }
    std::printf("float  G1 %.2e at h %.9g, S %.2e, Lambda %.2e (h < 1), %.2e at h %.9g\n", worst_g1, at_g1, worst_s,
                worst_core, worst_lambda, at_lambda);
    EXPECT_LE(worst_g1, 4e-7);
    EXPECT_LE(worst_s, 4e-7);
    EXPECT_LE(worst_core, 2e-6);
    EXPECT_LE(worst_lambda, 6e-5);
    EXPECT_EQ(smith_g1(cotangent_over_slope(0.0f, 0.1f)), 0);
    EXPECT_EQ(smith_g1(cotangent_over_slope(1.0f, 0.1f)), 1);
}

TEST(LambertW, Reference) {
    const ReferenceTable table("lambert_w");
    WorstErrors errors("lambert_w");
    for (std::size_t row = 0; row < table.size(); ++row) {
        errors.relative("w", row, lambert_w(table(row, "k")), table(row, "w"));
        errors.relative("w from ln_k", row, lambert_w_of_log(table(row, "ln_k")), table(row, "w"));
    }
    EXPECT_LE(errors.worst(), 1e-12);
}

TEST(LambertW, FloatBound) {
    double worst = 0, at = 0;
    for (double y = -80; y < 88; y += 1e-3) {
        const float yf = static_cast<float>(y);
        const double truth = lambert_w_of_log(static_cast<double>(yf));
        // Below y = -2 the root is e^y, whose argument carries |y| roundings.
        const double error = std::abs(lambert_w_of_log(yf) / truth - 1) / std::max(1.0, std::abs(y));
        if (error > worst) worst = error, at = yf;
    }
    std::printf("float  lambert_w %.2e max(1, |ln k|) at ln k %.9g\n", worst, at);
    EXPECT_LE(worst, 5e-7);
}

TEST(EffectiveRoughness, Reference) {
    const ReferenceTable table("effective_roughness");
    WorstErrors errors("effective_roughness");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double m = 2 * table(row, "alpha"), ci = table(row, "cos_theta_i"), cr = table(row, "cos_theta_r");
        const double he = excess_slope_he(ci, m) + excess_slope_he(cr, m);
        const double smith = excess_slope_smith(ci, m) + excess_slope_smith(cr, m);
        // He's K underflows to zero where erfc does; below 1e-290 its digits go.
        if (table(row, "K_he") > 1e-290 || table(row, "K_he") == 0) {
            errors.relative("K_he", row, he, table(row, "K_he"));
            errors.relative("z0 he", row, effective_roughness(he).mean_height, table(row, "z0_over_sigma0_he"));
        }
        errors.relative("sigma he", row, effective_roughness(he).sigma_ratio, table(row, "sigma_ratio_he"));
        if (table(row, "K_smith") > 1e-290 || table(row, "K_smith") == 0) {
            errors.relative("K_smith", row, smith, table(row, "K_smith"));
            errors.relative("z0 smith", row, effective_roughness(smith).mean_height,
                            table(row, "z0_over_sigma0_smith"));
        }
        errors.relative("sigma smith", row, effective_roughness(smith).sigma_ratio, table(row, "sigma_ratio_smith"));
    }
    for (const char* column : {"K_he", "z0 he", "sigma he", "sigma smith"})
        EXPECT_LE(errors.worst(column), 1e-12) << column;
    for (const char* column : {"K_smith", "z0 smith"}) EXPECT_LE(errors.worst(column), 1e-10) << column;  // as Lambda
}

TEST(EffectiveRoughness, FloatBound) {
    double worst = 0;
    for (double c = 0; c <= 1; c += 1e-4)
        for (const float m : {0.02f, 0.1f, 0.4f, 0.8f}) {
            const float cf = static_cast<float>(c);
            const double truth =
                effective_roughness(2 * excess_slope_he(static_cast<double>(cf), static_cast<double>(m))).sigma_ratio;
            const double value = effective_roughness(2 * excess_slope_he(cf, m)).sigma_ratio;
            ASSERT_TRUE(value > 0 && value <= 1);
            if (c > 0) worst = std::max(worst, std::abs(value - truth));
        }
    std::printf("float  sigma ratio %.2e\n", worst);
    EXPECT_LE(worst, 1e-6);
}

}  // namespace
}  // namespace brewster
