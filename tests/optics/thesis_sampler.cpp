#include "optics/thesis_sampler.h"

#include <gtest/gtest.h>

#include "direction_histogram.h"
#include "hemisphere_integral.h"
#include "random_light.h"
#include "reference_table.h"

namespace brewster {
namespace {

Vector<double> towards_source(double cos_i) {
    return {std::sqrt((1 - cos_i) * (1 + cos_i)), 0, cos_i};
}

template <class Real>
Vector<double> draw(RandomLight& random, const Vector<double>& i, double m) {
    const auto slopes = sample_thesis_slopes(Real(i.z), Real(m), Real(random.unit_float()), Real(random.unit_float()));
    const Vector<double> h =
        normalized(Vector<double>{m * static_cast<double>(slopes.along), m * static_cast<double>(slopes.across), 1});
    return reflected(-i, h);
}

/// Energy and direction bias against the tabulated quadratures, from 400 000 draws of the sampler a row: each within
/// 3 standard errors (120 comparisons, of which chance lets a few pass 3 but hardly one pass 4).
TEST(ThesisSampler, BiasReference) {
    const ReferenceTable table("sampler_bias"), albedo("beckmann_albedo");
    RandomLight random(1);
    const int draws = 400000;
    int beyond_three = 0, compared = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double cos_i = table(row, "cos_theta_i"), m = 2 * table(row, "alpha");
        ASSERT_EQ(albedo(row, "cos_theta_i"), cos_i);
        const double a_raw = albedo(row, "A_raw"), a_ss = albedo(row, "A_SS"), a_gg = albedo(row, "A_GG");
        const Vector<double> i = towards_source(cos_i);
        const double s_i = smith_s(cotangent_over_slope(cos_i, m));
        const double g_i = smith_g1(cotangent_over_slope(cos_i, m));
        // Mean cosine of the true lobes by quadrature.
        const auto target = hemisphere_integral<2>(cos_i, [&](const Vector<double>& r) -> std::array<double, 2> {
            const double raw = beckmann_d(normalized(i + r).z, m) / (4 * cos_i);
            return {raw * r.z, raw * r.z * g_i * smith_g1(cotangent_over_slope(r.z, m))};
        });
        std::array<double, 4> sum{}, squares{};  // S_r, cos_r, total variation without and with G1
        double below = 0;
        for (int n = 0; n < draws; ++n) {
            const Vector<double> r = draw<double>(random, i, m);
            const double p = thesis_pdf(i, r, m), raw = beckmann_d(normalized(i + r).z, m) / (4 * cos_i);
            const double q = raw / a_raw, q_gg = raw * g_i * smith_g1(cotangent_over_slope(r.z, m)) / a_gg;
            const std::array<double, 4> values{smith_s(cotangent_over_slope(std::max(r.z, 0.0), m)), r.z,
                                               std::max(0.0, 1 - q / p), std::max(0.0, 1 - q_gg / p)};
            for (std::size_t j = 0; j < 4; ++j) {
                sum[j] += values[j];
                squares[j] += values[j] * values[j];
            }
            // The same without limits: a free azimuth and an uncut Gaussian.
            const double radius = m * std::sqrt(-std::log1p(-random.unit())), phi = 2 * pi * random.unit();
            const Vector<double> h = normalized(Vector<double>{radius * std::cos(phi), radius * std::sin(phi), 1});
            below += dot(i, h) <= 0 || reflected(-i, h).z <= 0;
        }
        const auto mean = [&](std::size_t j) { return sum[j] / draws; };
        const auto error = [&](std::size_t j) {
            return std::sqrt(std::max(squares[j] / draws - mean(j) * mean(j), 0.0) / draws);
        };
        const auto compare = [&](const char* column, double value, double standard_error) {
            // One draw of weight 1 is the least that can be seen of a tail no draw met; in per cent.
            const double z = std::abs(value - table(row, column)) / (standard_error + 100.0 / draws);
            if (z > 3) std::printf("thesis %s row %zu: %.2f standard errors\n", column, row, z);
            beyond_three += z > 3;
            ++compared;
            EXPECT_LE(z, 4) << column << " row " << row;
        };
        EXPECT_NEAR(100 * (1 / a_raw - 1), table(row, "energy_raw"), 1e-6);
        EXPECT_NEAR(100 * (s_i / a_gg - 1), table(row, "energy_SvsGG"), 1e-6);
        compare("energy_SS", 100 * (s_i * mean(0) / a_ss - 1), 100 * s_i * error(0) / a_ss);
        compare("TV", 100 * mean(2), 100 * error(2));
        compare("TV_GG", 100 * mean(3), 100 * error(3));
        const double cos_raw = target[0] / a_raw, cos_gg = target[1] / a_gg;
        compare("dcos", 100 * (mean(1) / cos_raw - 1), 100 * error(1) / cos_raw);
        compare("dcos_GG", 100 * (mean(1) / cos_gg - 1), 100 * error(1) / cos_gg);
        const double share = below / draws;
        compare("below", 100 * share, 100 * std::sqrt(std::max(share * (1 - share), 1.0 / draws) / draws));
    }
    // Beyond 3 standard errors .27 % of 120 comparisons are expected: more than 3 have a chance of 4e-4.
    EXPECT_LE(beyond_three, 3) << compared;
}

template <class Real>
void chi_square_thesis(std::uint64_t seed, bool visible_normals_instead) {
    RandomLight random(seed);
    const int draws = 300000 / light_test_scale;
    const double cosines[] = {1.0, 0.87, 0.5, 0.26}, slopes[] = {0.3, 0.6};
    for (const double cos_i : cosines)
        for (const double m : slopes) {
            if (visible_normals_instead && cos_i > 0.9) continue;
            const Vector<double> i = towards_source(cos_i);
            DirectionHistogram histogram;
            for (int n = 0; n < draws; ++n) histogram.add(draw<Real>(random, i, m));
            const double p = chi_square_p(
                histogram.cells, cell_probabilities([&](const Vector<double>& r) {
                    return visible_normals_instead ? beckmann_lobe(i, r, {0, 0, 1}, m).pdf_i : thesis_pdf(i, r, m);
                }));
            if (visible_normals_instead) {
                EXPECT_LT(p, 1e-4) << cos_i << ' ' << m;
            } else {
                EXPECT_GT(p, sidak_level(2 * 8)) << cos_i << ' ' << m;
            }
        }
}

TEST(ThesisSampler, ChiSquare) {
    chi_square_thesis<double>(2, false);
}
TEST(ThesisSampler, ChiSquareFloat) {
    chi_square_thesis<float>(3, false);
}
TEST(ThesisSampler, IsNotTheVisibleNormals) {
    chi_square_thesis<double>(4, true);
}

}  // namespace
}  // namespace brewster
