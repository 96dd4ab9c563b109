#include "optics/poisson_lobes.h"

#include <gtest/gtest.h>

#include "direction_histogram.h"
#include "hemisphere_integral.h"
#include "optics/kirchhoff.h"
#include "random_light.h"
#include "reference_table.h"
#include "upright.h"

namespace brewster {
namespace {

const OrderRules rules;

/// The whole series of E1: value and density of poisson_lobe's sums, order by order.
OrderSums<double> whole_series(double g, double h_i, double h_r, double tan2, double scale) {
    OrderSums<double> sum{0, 0};
    const int last = static_cast<int>(g + 12 * std::sqrt(g) + 40);
    for (int n = 1; n <= last; ++n) {
        const double p = std::exp(n * std::log(g) - g - std::lgamma(n + 1.0)), ratio = g / n;
        if (p < 1e-18) continue;
        const double seen = p * ratio * std::exp(-tan2 * ratio) * smith_g1(h_i * std::sqrt(ratio)) * scale;
        sum.density += seen;
        sum.value += seen * smith_g1(h_r * std::sqrt(ratio));
    }
    return sum;
}

/// E1 from i, as cos_r times BRDF: by the whole series or by the nodes.
struct E1 {
    double series, nodes;
};
E1 e1(const Vector<double>& i, const Vector<double>& r, double m, double phase) {
    const Vector<double> h = normalized(i + r);
    const double g = phase * phase * i.z * i.z, c2 = h.z * h.z;
    const double h_i = cotangent_over_slope(i.z, m), h_r = cotangent_over_slope(r.z, m);
    const double tan2 = (1 - c2) / c2 / (m * m), scale = 1 / (4 * pi * m * m * c2 * c2);
    return {whole_series(g, h_i, h_r, tan2, scale).value / i.z,
            sum_orders(rules.at(g), g, h_i, h_r, tan2, scale).value / i.z};
}

TEST(PoissonLobes, WeightsAddUpToOne) {
    for (double g = 1e-9; g < 1e7; g *= 1.03) {
        const auto nodes = rules.at(g);
        double sum = 0, inverse_order = 0, exact = 0;
        for (std::size_t j = 0; j < order_nodes; ++j) {
            sum += nodes.weight[j];
            inverse_order += nodes.weight[j] * nodes.root[j] * nodes.root[j];
            ASSERT_GE(nodes.weight[j], -1e-7);
            ASSERT_GT(nodes.root[j], 0);
        }
        ASSERT_NEAR(sum, 1, 3e-7);  // the table is float
        if (g > 2000) continue;
        for (int n = 1; n < g + 12 * std::sqrt(g) + 40; ++n)
            exact += std::exp(n * std::log(g) - g - std::lgamma(n + 1.0)) * g / n;
        ASSERT_NEAR(inverse_order * -std::expm1(-g) / exact, 1, 1e-3) << g;  // the peak of the lobe
    }
}

/// The nodes against the series: lobe values within 1e-3 of the largest value of the lobe, albedos within 1e-3.
TEST(PoissonLobes, NodesStayWithinAThousandthOfTheSeries) {
    double worst = 0, worst_albedo = 0;
    RandomLight random(1);
    for (const double m : {0.05, 0.2, 0.5})
        for (const double g0 : {0.02, 0.3, 1.0, 3.0, 6.0, 10.0, 18.0, 40.0, 150.0, 800.0})
            for (const double cos_i : {1.0, 0.7, 0.3, 0.1}) {
                const double phase = std::sqrt(g0);
                const Vector<double> i = towards_source(cos_i);
                double peak = 0, error = 0;
                const auto look = [&](const Vector<double>& r) {
                    if (r.z <= 1e-3) return;
                    const E1 at = e1(i, r, m, phase);
                    peak = std::max(peak, at.series);
                    error = std::max(error, std::abs(at.nodes - at.series));
                };
                look({-i.x, 0, i.z});
                for (int n = 0; n < 300 / light_test_scale + 20; ++n) {
                    const double a = random.between(0, 4), turn = random.between(0, 2 * pi);
                    const Vector<double> h =
                        normalized(Vector<double>{m * a * std::cos(turn), m * a * std::sin(turn), 1});
                    look(reflected(-i, h));
                }
                worst = std::max(worst, error / peak);
                if (m != 0.2 || light_test_scale > 1) continue;
                const auto albedo = hemisphere_integral<2>(
                    cos_i,
                    [&](const Vector<double>& r) -> std::array<double, 2> {
                        const E1 at = e1(i, r, m, phase);
                        return {at.series, at.nodes};
                    },
                    4);
                worst_albedo = std::max(worst_albedo, std::abs(albedo[0] - albedo[1]) / albedo[0]);
            }
    std::printf("E1R    nodes against series: %.2e of the peak, albedo %.2e\n", worst, worst_albedo);
    EXPECT_LE(worst, 1e-3);
    EXPECT_LE(worst_albedo, 1e-3);
}

/// Moments of E1 and of the single-lobe E2, by the whole series.
TEST(PoissonLobes, EngineAlbedoReference) {
    const ReferenceTable table("engine_albedo");
    WorstErrors errors("engine_albedo");
    for (std::size_t row = 0; row<table.size(); row += light_test_scale> 1 ? 5 : 1) {
        const double sigma = table(row, "sigma0"), tau = table(row, "tau"), cos_i = table(row, "cos_theta_i");
        const double m = 2 * sigma / tau, g = specular_g(sigma, cos_i);
        const Vector<double> i = towards_source(cos_i);
        const double m2 = m / std::sqrt(-std::expm1(-g));
        const auto a = hemisphere_integral<6>(
            cos_i,
            [&](const Vector<double>& r) -> std::array<double, 6> {
                const double one = e1(i, r, m, 4 * pi * sigma).series;
                const double two = -std::expm1(-g) * beckmann_lobe(i, r, up, m2).value * r.z;
                return {one, one * r.z, -one * r.x, two, two * r.z, -two * r.x};
            },
            8);
        const char* columns[] = {"E1_albedo", "E1_cos", "E1_fwd", "E2_albedo", "E2_cos", "E2_fwd"};
        for (std::size_t j = 0; j < 6; ++j) errors.absolute(columns[j], row, a[j], table(row, columns[j]));
        errors.relative("g_s", row, g, table(row, "g_s"));
        errors.relative("spec", row, std::exp(-g), table(row, "spec"));
    }
    for (const char* column : {"E1_albedo", "E1_cos", "E1_fwd", "E2_albedo", "E2_cos", "E2_fwd"})
        EXPECT_LE(errors.worst(column), 1e-6) << column;  // the file's tolerance: double quadrature
    EXPECT_LE(errors.worst("g_s"), 1e-12);
    EXPECT_LE(errors.worst("spec"), 1e-12);
}

KirchhoffSurface<double, 3> surface_of(double m, double phase) {
    return {m, {phase, phase * 612 / 549, phase * 612 / 465}};
}

TEST(PoissonLobes, Reciprocity) {
    RandomLight random(2);
    double worst = 0;
    for (int n = 0; n < 100000 / light_test_scale; ++n) {
        Vector<double> i = random.direction(), r = random.direction();
        i.z = std::abs(i.z);
        r.z = std::abs(r.z);
        const auto surface = surface_of(random.between(0.02, 0.6), std::pow(10.0, random.between(-1, 1.5)));
        const auto forth = poisson_lobe(rules, i, r, up, surface), back = poisson_lobe(rules, r, i, up, surface);
        for (std::size_t band = 0; band < 3; ++band)
            if (forth.value[band] > 1e-200) worst = std::max(worst, std::abs(forth.value[band] / back.value[band] - 1));
        if (forth.pdf_i > 1e-200) worst = std::max(worst, std::abs(forth.pdf_i / back.pdf_r - 1));
    }
    EXPECT_LE(worst, 1e-6);
}

/// Mirror and lobe together never reflect more than falls in, from either side (they are the same function), F = 1.
TEST(PoissonLobes, AlbedoIsAtMostOne) {
    double largest = 0;
    for (const double m : {0.05, 0.2, 0.4, 0.6})
        for (const double phase : {0.2, 1.0, 2.0, 4.0, 9.0, 25.0})
            for (const double cos_i : {1.0, 0.6, 0.2, 0.05, 0.01}) {
                const auto surface = surface_of(m, phase);
                const auto a = hemisphere_integral<3>(
                    cos_i,
                    [&](const Vector<double>& r) -> std::array<double, 3> {
                        const auto lobe = poisson_lobe(rules, towards_source(cos_i), r, up, surface);
                        return {lobe.value[0] * r.z, lobe.value[1] * r.z, lobe.value[2] * r.z};
                    },
                    5);
                const auto mirror = mirror_share(surface, cos_i);
                for (std::size_t band = 0; band < 3; ++band) largest = std::max(largest, a[band] + mirror[band]);
            }
    std::printf("E1R    largest albedo %.9f\n", largest);
    EXPECT_LE(largest, 1 + 1e-6);
}

template <class Real>
void chi_square_e1r(std::uint64_t seed, double pdf_slope_factor, bool expect_match) {
    RandomLight random(seed);
    const int draws = 400000 / light_test_scale;
    const std::array<std::array<double, 3>, 6> cases{
        {{1.0, 0.3, 1.2}, {0.6, 0.3, 1.2}, {0.6, 0.3, 4.0}, {0.2, 0.4, 6.0}, {0.05, 0.5, 30.0}, {0.8, 0.2, 0.5}}};
    double smallest = 1;
    for (const auto& [cos_i, m, phase] : cases) {
        const auto surface = surface_of(m, phase);
        const KirchhoffSurface<Real, 3> real_surface{
            Real(m), {Real(surface.phase[0]), Real(surface.phase[1]), Real(surface.phase[2])}};
        const Vector<double> i = towards_source(cos_i);
        const Vector<Real> k{Real(-i.x), Real(0), Real(-i.z)}, s{Real(0), Real(1), Real(0)},
            n{Real(0), Real(0), Real(1)};
        const auto plane = plane_of_incidence(k, s, n);
        DirectionHistogram histogram;
        double mirrored = 0;
        for (int draw = 0; draw < draws; ++draw) {
            const Real slope = sample_slope(rules, real_surface, Real(cos_i), Real(random.unit_float()));
            if (slope == 0) {
                ++mirrored;
                continue;
            }
            const auto out = sample_facet(k, n, plane, slope, Real(random.unit_float()), Real(random.unit_float()),
                                          Real(random.unit_float()));
            histogram.add({static_cast<double>(out.direction.x), static_cast<double>(out.direction.y),
                           static_cast<double>(out.direction.z)});
        }
        const auto share = mirror_share(surface, cos_i);
        const double mirror = (share[0] + share[1] + share[2]) / 3;
        const auto wrong = surface_of(m * pdf_slope_factor, phase);
        auto expected =
            cell_probabilities([&](const Vector<double>& r) { return poisson_lobe(rules, i, r, up, wrong).pdf_i; });
        expected.back() = std::max(0.0, expected.back() - mirror);
        expected.push_back(mirror);
        histogram.cells.push_back(mirrored);
        const double p = chi_square_p(histogram.cells, expected);
        if (expect_match) {
            EXPECT_GT(p, sidak_level(2 * 6)) << cos_i << ' ' << m << ' ' << phase;
        }
        smallest = std::min(smallest, p);
    }
    if (!expect_match) {
        EXPECT_LT(smallest, 1e-4);
    }
}

TEST(PoissonLobes, SamplerChiSquare) {
    chi_square_e1r<double>(3, 1, true);
}
TEST(PoissonLobes, SamplerChiSquareFloat) {
    chi_square_e1r<float>(4, 1, true);
}
TEST(PoissonLobes, SamplerNegativeControl) {
    chi_square_e1r<double>(5, light_test_scale > 1 ? 1.2 : 1.05, false);
}

/// A band's weight, value cos / pdf, is bounded by the number of bands, so one lobe choice serves all colours.
TEST(PoissonLobes, WeightsAreBoundedByBands) {
    RandomLight random(6);
    for (int n = 0; n < 50000 / light_test_scale; ++n) {
        Vector<double> i = random.direction(), r = random.direction();
        i.z = std::abs(i.z);
        r.z = std::abs(r.z);
        const auto lobe = poisson_lobe(rules, i, r, up,
                                       surface_of(random.between(0.02, 0.6), std::pow(10.0, random.between(-1, 1.5))));
        if (lobe.pdf_i < 1e-200) continue;
        for (const double value : lobe.value) ASSERT_LE(value * r.z / lobe.pdf_i, 3 + 1e-9);
    }
}

/// In the limit of many orders E1R is model V.
TEST(PoissonLobes, LimitIsModelV) {
    RandomLight random(7);
    const KirchhoffSurface<double, 1> surface{0.3, {100}};
    for (int n = 0; n < 2000; ++n) {
        const Vector<double> i = towards_source(random.between(0.3, 1));
        const Vector<double> h =
            normalized(Vector<double>{0.3 * random.between(-1, 1), 0.3 * random.between(-1, 1), 1});
        const Vector<double> r = reflected(-i, h);
        if (r.z < 0.3) continue;
        const double v = beckmann_lobe(i, r, up, 0.3).value;
        ASSERT_NEAR(poisson_lobe(rules, i, r, up, surface).value[0] / v, 1, 3e-3);  // 1/g at g >= 900
    }
}

}  // namespace
}  // namespace brewster
