#include "optics/polarized_diffuse.h"

#include <gtest/gtest.h>

#include "direction_histogram.h"
#include "hemisphere_integral.h"
#include "optics/materials.h"
#include "optics/rough_interface.h"
#include "random_light.h"
#include "reference_table.h"

namespace brewster {
namespace {

TEST(PolarizedDiffuse, FresnelDiffuseReference) {
    const ReferenceTable table("fresnel_diffuse");
    WorstErrors errors("fresnel_diffuse");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double n = table(row, "n"), external = external_reflectance(n);
        errors.relative("F_external", row, external, table(row, "F_external"));
        errors.relative("F_internal", row, internal_reflectance(external, n), table(row, "F_internal"));
    }
    EXPECT_LE(errors.worst(), 1e-12);
}

TEST(PolarizedDiffuse, QuadratureMeetsClosedForm) {
    EXPECT_EQ(external_reflectance(1), 0);
    EXPECT_NEAR(external_reflectance(1.00999999999) / external_reflectance(1.01), 1, 1e-8);
}

TEST(PolarizedDiffuse, MuellerBrdfReference) {
    const ReferenceTable table("polarized_diffuse");
    WorstErrors errors("polarized_diffuse");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double n = table(row, "n"), rho = table(row, "rho"), ci = table(row, "cos_theta_i"),
                     co = table(row, "cos_theta_o");
        const double external = external_reflectance(n), internal = internal_reflectance(external, n);
        const auto in = smooth_passage(ci, n), out = smooth_passage(co, n);
        const double factor = base_radiance_factor(rho, n, internal);
        const auto from_s0 = base_radiance<4>(out, entered_power(in, Stokes<double, 4>{{1, 0, 0, 0}}), factor);
        const auto from_s1 = base_radiance<4>(out, entered_power(in, Stokes<double, 4>{{0, 1, 0, 0}}), factor);
        errors.relative("F_internal", row, internal, table(row, "F_internal"));
        errors.relative("m00", row, from_s0.s0(), table(row, "m00"));
        errors.relative("m01", row, from_s1.s0(), table(row, "m01"));
        errors.relative("m10", row, from_s0.s1(), table(row, "m10"));
        errors.relative("m11", row, from_s1.s1(), table(row, "m11"));
        errors.relative("albedo", row, in.unpolarized * base_survival(rho, internal), table(row, "albedo"));
        errors.relative("S1_over_S0_out", row, from_s0.s1() / from_s0.s0(), table(row, "S1_over_S0_out"));
    }
    EXPECT_LE(errors.worst(), 1e-12);
}

/// Reflected + base is 1 for a white base, for light polarized either way, from both sides of use.
TEST(PolarizedDiffuse, WhiteBaseReflectsEverything) {
    for (const double n : {1.01, 1.33, 1.5, 2.4, 10.0}) {
        const double external = external_reflectance(n), internal = internal_reflectance(external, n);
        for (double c = 1e-4; c <= 1; c += 1e-2) {
            const auto reflection = mueller_reflection(c, n);
            const auto in = smooth_passage(c, n);
            for (const double s1 : {-1.0, 0.0, 1.0}) {
                const Stokes<double, 4> light{{1, s1, 0, 0}};
                const double base = entered_power(in, light) * base_survival(1.0, internal);
                EXPECT_NEAR((reflection * light).s0() + base, 1, 1e-12);
            }
        }
        // The exit integrates to what survives: 2 pi int radiance cos dcos = rho (1 - Fi)/(1 - rho Fi) of the entered.
        const auto out = hemisphere_integral<1>(1.0, [&](const Vector<double>& r) -> std::array<double, 1> {
            return {base_radiance<1>(smooth_passage(r.z, n), 1.0, base_radiance_factor(0.7, n, internal)).s0() * r.z};
        });
        EXPECT_NEAR(out[0], base_survival(0.7, internal), 1e-8);
    }
}

TEST(PolarizedDiffuse, CosineChiSquareAndExitWeight) {
    RandomLight random(1);
    DirectionHistogram histogram;
    const int draws = 400000 / light_test_scale;
    const double n = 1.5, external = external_reflectance(n);
    double sum = 0, squares = 0;
    for (int i = 0; i < draws; ++i) {
        const Vector<double> d = sample_cosine(random.unit(), random.unit());
        histogram.add(d);
        const double weight = exit_weight(smooth_passage(d.z, n), external);
        sum += weight;
        squares += weight * weight;
    }
    EXPECT_GT(chi_square_p(histogram.cells, cell_probabilities([](const Vector<double>& d) { return d.z / pi; })),
              1e-4);
    EXPECT_LT(chi_square_p(histogram.cells, cell_probabilities([](const Vector<double>&) { return 0.5 / pi; })), 1e-4);
    // weight = f cos / pdf over the survival: its mean is 1.
    EXPECT_NEAR(sum / draws, 1, 4 * std::sqrt((squares / draws - 1) / draws + 1e-12));
}

TEST(RoughInterface, AlbedoReference) {
    const ReferenceTable table("rough_interface_albedo");
    WorstErrors errors("rough_interface_albedo");
    for (std::size_t row = 0; row<table.size(); row += light_test_scale> 1 ? 7 : 1) {
        const double c = std::cos(radians(table(row, "theta_deg")));
        const auto albedo = directional_albedo(c, table(row, "n"), 0, table(row, "m"), 5);
        errors.absolute("E", row, albedo.unpolarized, table(row, "E"));
        errors.absolute("E1", row, albedo.s_minus_p, table(row, "E1"));
        const double tolerance = std::max(1e-6, table(row, "quad_err"));  // the file's
        EXPECT_NEAR(albedo.unpolarized, table(row, "E"), tolerance) << row;
        EXPECT_NEAR(albedo.s_minus_p, table(row, "E1"), tolerance) << row;
        if (row % 5 != 0) continue;
        const RoughInterface rough(table(row, "n"), table(row, "m"));
        errors.absolute("Fe", row, rough.external_reflectance(), table(row, "Fe"));
    }
    EXPECT_LE(errors.worst("Fe"), 1e-4);  // the interpolated table, against 1e-5 of the file
}

/// The lobe's own albedo and what the table lets into a white base: 1 for either polarization.
TEST(RoughInterface, LobeAndWhiteBaseReflectEverything) {
    double worst = 0, at_c = 0, at_m = 0, at_n = 0;
    for (const double n : {1.01, 1.5, 2.4, 10.0})
        for (const double m : {0.05, 0.1, 0.4, 0.8}) {
            const RoughInterface rough(n, m);
            for (double c = 0.0013; c <= 1; c += light_test_scale > 1 ? 0.0931 : 0.0131) {
                const auto albedo = directional_albedo(c, n, 0, m, 4);
                const Passage<double> passage = rough.passage(c);
                for (const double s1 : {-1.0, 1.0}) {
                    const double total =
                        albedo.unpolarized + albedo.s_minus_p * s1 + passage.unpolarized + passage.s_minus_p * s1;
                    if (std::abs(total - 1) > worst) worst = std::abs(total - 1), at_c = c, at_m = m, at_n = n;
                }
            }
        }
    std::printf("table  rough interface and white base: 1 within %.2e (cos %.4f, m %.2f, n %.2f)\n", worst, at_c, at_m,
                at_n);
    EXPECT_LE(worst, 1e-6);
}

/// With the table's own Fe a white base returns all that enters, and what enters is 1 - E for either polarization.
TEST(RoughInterface, WhiteBaseReflectsEverything) {
    for (const double n : {1.01, 1.33, 2.4, 10.0})
        for (const double m : {0.1, 0.6}) {
            const RoughInterface rough(n, m);
            const double internal = rough.internal_reflectance();
            EXPECT_NEAR(base_survival(1.0, internal), 1, 1e-12);
            // What leaves, integrated over the hemisphere in x = sqrt(cos), against what survives.
            double out = 0;
            const int steps = 12800;
            for (int k = 0; k < steps; ++k) {
                const double x = (k + 0.5) / steps;
                out += base_radiance<1>(rough.passage(x * x), 1.0, base_radiance_factor(1.0, n, internal)).s0() * 2 *
                       pi * x * x * 2 * x / steps;
            }
            EXPECT_NEAR(out, 1, 1e-6);
            for (double c = 1e-3; c < 1; c += 0.01) {
                const Passage<double> in = rough.passage(c);
                EXPECT_GE(in.unpolarized - std::abs(in.s_minus_p), 0);
                EXPECT_LE(in.unpolarized + std::abs(in.s_minus_p), 1 + 1e-6);
            }
        }
}

/// Model V alone: albedo of both polarizations at most 1 for dielectrics and metals; reciprocity makes it both sides.
TEST(RoughInterface, AlbedoOfModelVIsAtMostOne) {
    double largest = 0;
    for (const double m : {0.05, 0.2, 0.5, 0.8})
        for (const double c : {1.0, 0.5, 0.2, 0.05, 0.01}) {
            for (const double n : {1.01, 1.5, 10.0}) {
                const auto albedo = directional_albedo(c, n, 0, m, 3);
                largest = std::max(largest, albedo.unpolarized + std::abs(albedo.s_minus_p));
            }
            for (const auto& metal : {named_materials[6], named_materials[7]}) {
                const auto albedo = directional_albedo(c, metal.n[0], metal.k[0], m, 3);
                largest = std::max(largest, albedo.unpolarized + std::abs(albedo.s_minus_p));
            }
        }
    EXPECT_LE(largest, 1 + 1e-6);
}

}  // namespace
}  // namespace brewster
