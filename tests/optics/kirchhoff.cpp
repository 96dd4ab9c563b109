#include "optics/kirchhoff.h"

#include <gtest/gtest.h>

#include "hemisphere_integral.h"
#include "optics/effective_roughness.h"
#include "optics/fresnel.h"
#include "random_light.h"
#include "reference_table.h"

namespace brewster {
namespace {

TEST(Kirchhoff, SeriesReference) {
    const ReferenceTable table("kirchhoff_series");
    WorstErrors errors("kirchhoff_series");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double g = table(row, "g"), c = table(row, "c");
        const double ln_f = log_kirchhoff_series(g, c), truth = table(row, "ln_f");
        errors.absolute("ln_f/(1+|ln_f|)", row, ln_f / (1 + std::abs(truth)), truth / (1 + std::abs(truth)));
        if (table(row, "f") < 1e-300) continue;
        // f carries |ln f| roundings of its logarithm; the file asks for 1e-13 there, measured against 1 + |ln f|.
        errors.absolute("f, relative/(1+|ln_f|)", row,
                        (kirchhoff_series(g, c) / table(row, "f") - 1) / (1 + std::abs(truth)), 0);
        errors.relative("f", row, kirchhoff_series(g, c), table(row, "f"));
        errors.relative("f_over_1mexpmg", row, kirchhoff_series(g, c) / -std::expm1(-g), table(row, "f_over_1mexpmg"));
    }
    EXPECT_LE(errors.worst("ln_f/(1+|ln_f|)"), 1e-12);
    EXPECT_LE(errors.worst("f, relative/(1+|ln_f|)"), 1e-13);
    EXPECT_LE(errors.worst("f"), 1e-12);
    EXPECT_LE(errors.worst("f_over_1mexpmg"), 1e-12);
}

/// Directional albedos of the whole model: mirror, lobe with and without shadowing, Fresnel, He's effective roughness.
TEST(Kirchhoff, LobeAlbedoReference) {
    const ReferenceTable table("lobe_albedo");
    WorstErrors errors("lobe_albedo");
    const int stride = light_test_scale > 1 ? 9 : 1;
    for (std::size_t row = 0; row < table.size(); row += static_cast<std::size_t>(stride)) {
        const double sigma = table(row, "sigma0"), tau = table(row, "tau"), cos_i = table(row, "cos_theta_i");
        const double m = 2 * sigma / tau, h_i = cotangent_over_slope(cos_i, m);
        const double s_i = smith_s(h_i), g1_i = smith_g1(h_i), k_i = excess_slope_he(cos_i, m);
        const Vector<double> i{std::sqrt((1 - cos_i) * (1 + cos_i)), 0, cos_i};
        const auto a = hemisphere_integral<8>(cos_i, [&](const Vector<double>& r) -> std::array<double, 8> {
            const double h_r = cotangent_over_slope(r.z, m), s_r = smith_s(h_r), g1_r = smith_g1(h_r);
            const double lobe = kirchhoff_lobe(i, r, sigma, tau);
            const double sigma_he = sigma * effective_roughness(k_i + excess_slope_he(r.z, m)).sigma_ratio;
            const double he = kirchhoff_lobe(i, r, sigma_he, tau) * s_i * s_r;
            const double cos_h = std::min(1.0, std::sqrt(0.5 * (1 + dot(i, r))));
            const double glass = dielectric_interface(cos_h, 1.5).reflection.a;
            const double ten = dielectric_interface(cos_h, 10.0).reflection.a;
            const double gg = lobe * g1_i * g1_r;
            return {lobe, lobe * s_i * s_r, gg, gg * glass, gg * ten, he, he * glass, he * ten};
        });
        const double g_he = specular_g(sigma * effective_roughness(2 * k_i).sigma_ratio, cos_i);
        const double g_s = specular_g(sigma, cos_i);
        errors.relative("g_s0", row, g_s, table(row, "g_s0"));
        errors.relative("spec_s0", row, std::exp(-g_s), table(row, "spec_s0"));
        errors.relative("g_He", row, g_he, table(row, "g_He"));
        errors.relative("spec_He", row, s_i * s_i * std::exp(-g_he), table(row, "spec_He"));
        errors.relative("S_i", row, s_i, table(row, "S_i"));
        errors.relative("G1_i", row, g1_i, table(row, "G1_i"));
        const char* columns[] = {"A_raw", "A_SS", "A_GG", "A_GG_n1.5", "A_GG_n10", "A_He", "A_He_n1.5", "A_He_n10"};
        const double tolerance = std::max(1e-8, 10 * table(row, "quad_err"));  // the file's
        for (std::size_t j = 0; j < 8; ++j) {
            errors.absolute(columns[j], row, a[j], table(row, columns[j]));
            EXPECT_NEAR(a[j], table(row, columns[j]), tolerance) << columns[j] << " row " << row;
        }
    }
    // e^-g carries g roundings; g is at most 790.
    for (const char* column : {"g_s0", "spec_s0", "g_He", "spec_He", "S_i", "G1_i"})
        EXPECT_LE(errors.worst(column), 1e-12) << column;
}

}  // namespace
}  // namespace brewster
