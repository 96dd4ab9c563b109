#include "optics/beckmann.h"

#include <gtest/gtest.h>

#include "direction_histogram.h"
#include "hemisphere_integral.h"
#include "random_light.h"
#include "reference_table.h"
#include "upright.h"

namespace brewster {
namespace {

/// Draws reflected directions in a frame whose x axis points towards the source.
template <class Real>
Vector<double> draw(RandomLight& random, double cos_i, double m, Vector<double>* facet = nullptr) {
    const Vector<double> i = towards_source(cos_i);
    const Vector<Real> k{Real(-i.x), Real(0), Real(-i.z)}, s{Real(0), Real(1), Real(0)}, n{Real(0), Real(0), Real(1)};
    const auto plane = plane_of_incidence(k, s, n);
    const auto out = sample_facet(k, n, plane, Real(m), Real(random.unit_float()), Real(random.unit_float()),
                                  Real(random.unit_float()));
    if (facet)
        *facet = {static_cast<double>(out.facet.x), static_cast<double>(out.facet.y), static_cast<double>(out.facet.z)};
    return {static_cast<double>(out.direction.x), static_cast<double>(out.direction.y),
            static_cast<double>(out.direction.z)};
}

constexpr int draws = 400000 / light_test_scale;
constexpr double test_cosines[] = {1.0, 0.87, 0.5, 0.17, 0.03};
constexpr double test_slopes[] = {0.2, 0.4, 0.8};
constexpr int test_count = 2 * 5 * 3;

template <class Real>
void chi_square_visible_normals(std::uint64_t seed) {
    RandomLight random(seed);
    for (const double cos_i : test_cosines)
        for (const double m : test_slopes) {
            const Vector<double> i = towards_source(cos_i);
            DirectionHistogram histogram;
            for (int n = 0; n < draws; ++n) histogram.add(draw<Real>(random, cos_i, m));
            const auto expected =
                cell_probabilities([&](const Vector<double>& r) { return beckmann_lobe(i, r, up, m).pdf_i; });
            EXPECT_GT(chi_square_p(histogram.cells, expected), sidak_level(test_count)) << cos_i << ' ' << m;
        }
}

TEST(Beckmann, VisibleNormalsChiSquare) {
    chi_square_visible_normals<double>(1);
}
TEST(Beckmann, VisibleNormalsChiSquareFloat) {
    chi_square_visible_normals<float>(2);
}

/// The same histograms against a slope 3 % off, and against all normals instead of the visible ones, are rejected.
TEST(Beckmann, VisibleNormalsNegativeControl) {
    RandomLight random(3);
    const double cos_i = 0.5, m = 0.4;
    const Vector<double> i = towards_source(cos_i);
    DirectionHistogram histogram;
    for (int n = 0; n < draws; ++n) histogram.add(draw<double>(random, cos_i, m));
    const auto slope_off =
        cell_probabilities([&](const Vector<double>& r) { return beckmann_lobe(i, r, up, 1.03 * m).pdf_i; });
    const auto all_normals = cell_probabilities([&](const Vector<double>& r) {
        const Vector<double> h = normalized(i + r);
        return beckmann_d(h.z, m) * h.z / (4 * dot(i, h));
    });
    if (light_test_scale == 1) {
        EXPECT_LT(chi_square_p(histogram.cells, slope_off), 1e-4);  // needs all the draws to be seen
    }
    EXPECT_LT(chi_square_p(histogram.cells, all_normals), 1e-4);
}

TEST(Beckmann, DensityOfNormalsProjectsToOne) {
    for (const double m : {0.05, 0.3, 0.8}) {
        double sum = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i) {  // in tan(delta)/m = t, dOmega cos = 2 pi m^2 t cos^4 dt
            const double t = 6 * (i + 0.5) / n, c = 1 / std::sqrt(1 + m * m * t * t);
            sum += beckmann_d(c, m) * 2 * pi * m * m * t * std::pow(c, 4) * 6 / n;
        }
        EXPECT_NEAR(sum, 1, 1e-8);
    }
}

TEST(Beckmann, WeightIsValueTimesCosineOverPdf) {
    RandomLight random(5);
    for (int n = 0; n < 20000; ++n) {
        const double cos_i = random.between(0.02, 1), m = random.between(0.05, 0.8);
        const Vector<double> r = draw<double>(random, cos_i, m);
        if (r.z <= 1e-6) continue;
        const auto lobe = beckmann_lobe(towards_source(cos_i), r, up, m);
        ASSERT_NEAR(lobe.value * r.z / lobe.pdf_i, smith_g1(cotangent_over_slope(r.z, m)), 1e-12);
    }
}

TEST(Beckmann, Reciprocity) {
    RandomLight random(6);
    for (int n = 0; n < 100000 / light_test_scale; ++n) {
        Vector<double> i = random.direction(), r = random.direction();
        i.z = std::abs(i.z);
        r.z = std::abs(r.z);
        const double m = random.between(0.02, 0.8);
        const auto forth = beckmann_lobe(i, r, up, m), back = beckmann_lobe(r, i, up, m);
        ASSERT_NEAR(forth.value, back.value, 1e-12 * forth.value + 1e-300);
        ASSERT_NEAR(forth.pdf_i, back.pdf_r, 1e-12 * forth.pdf_i + 1e-300);
    }
}

TEST(Beckmann, AlbedoReference) {
    const ReferenceTable table("beckmann_albedo");
    WorstErrors errors("beckmann_albedo");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double m = 2 * table(row, "alpha"), cos_i = table(row, "cos_theta_i");
        const Vector<double> i = towards_source(cos_i);
        const double h_i = cotangent_over_slope(cos_i, m), lambda_i = smith_lambda(h_i), s_i = smith_s(h_i);
        const auto a = hemisphere_integral<4>(cos_i, [&](const Vector<double>& r) -> std::array<double, 4> {
            const Vector<double> h = normalized(i + r);
            const double raw = beckmann_d(h.z, m) / (4 * cos_i), h_r = cotangent_over_slope(r.z, m);
            const double lambda_r = smith_lambda(h_r);
            return {raw, raw * s_i * smith_s(h_r), raw / ((1 + lambda_i) * (1 + lambda_r)),
                    raw / (1 + lambda_i + lambda_r)};
        });
        errors.relative("A_raw", row, a[0], table(row, "A_raw"));
        errors.relative("A_SS", row, a[1], table(row, "A_SS"));
        errors.relative("A_GG", row, a[2], table(row, "A_GG"));
        errors.relative("A_GG_correlated", row, a[3], table(row, "A_GG_correlated"));
        errors.relative("S_i", row, s_i, table(row, "S_i"));
        errors.relative("G1_i", row, smith_g1(h_i), table(row, "G1_i"));
        const double tolerance = std::max(1e-8, 10 * table(row, "quad_err"));
        EXPECT_NEAR(a[0], table(row, "A_raw"), tolerance);
        EXPECT_NEAR(a[1], table(row, "A_SS"), tolerance);
        EXPECT_NEAR(a[2], table(row, "A_GG"), tolerance);
        EXPECT_NEAR(a[3], table(row, "A_GG_correlated"), tolerance);
    }
    EXPECT_LE(errors.worst("S_i"), 1e-12);
    EXPECT_LE(errors.worst("G1_i"), 1e-12);
}

/// The sampler's mean weight against the 16-digit albedo: 400 000 draws, 4 standard errors.
TEST(Beckmann, SampledAlbedoReference) {
    const ReferenceTable table("beckmann_albedo");
    RandomLight random(9);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double m = 2 * table(row, "alpha"), cos_i = table(row, "cos_theta_i");
        double sum = 0, squares = 0;
        for (int n = 0; n < draws; ++n) {
            const Vector<double> r = draw<float>(random, cos_i, m);
            const double weight = r.z > 0 ? smith_g1(cotangent_over_slope(r.z, m)) : 0;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / draws, variance = std::max(squares / draws - mean * mean, 0.0) / draws;
        // One draw is the least that can be seen of a tail no draw met; 1e-6 for the roundings of a float direction.
        EXPECT_NEAR(mean, table(row, "A_GG"), 4 * (std::sqrt(variance) + 1.0 / draws) + 1e-6) << row;
    }
}

}  // namespace
}  // namespace brewster
