#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "statistics/chi_square.h"

namespace brewster {
namespace {

// Two degrees: the tail is exp(-x/2). One degree: the tail of |z|. Four: exp(-x/2)(1 + x/2).
TEST(ChiSquare, TailHasItsClosedForms) {
    for (const double x : {0.01, 0.5, 1.0, 3.0, 10.0, 40.0}) {
        EXPECT_NEAR(chi_square_tail(x, 2), std::exp(-x / 2), 1e-12);
        EXPECT_NEAR(chi_square_tail(x, 1), std::erfc(std::sqrt(x / 2)), 1e-12);
        EXPECT_NEAR(chi_square_tail(x, 4), std::exp(-x / 2) * (1 + x / 2), 1e-12);
    }
    EXPECT_NEAR(chi_square_tail(999.3, 1000), 0.5, 0.01);
    EXPECT_EQ(chi_square_tail(0, 5), 1);
}

TEST(ChiSquare, PoolsSmallCells) {
    const std::vector<double> counts = {10, 2, 3, 1, 20, 4}, expected = {12, 3, 2, 1, 20, 2};
    const ChiSquare test = chi_square_test(counts, expected);
    // 12 | 3 + 2 | 1 + 20 + 2: the last cell alone expects too little and joins its neighbour.
    EXPECT_EQ(test.degrees, 2);
    EXPECT_NEAR(test.statistic, 4.0 / 12 + 0 + 4.0 / 23, 1e-12);
}

TEST(ChiSquare, RefusesExpectationsOfAnotherTotal) {
    const std::vector<double> counts = {10, 10}, expected = {10, 20};
    EXPECT_THROW(chi_square_test(counts, expected), std::invalid_argument);
}

std::vector<double> thrown_counts(std::uint64_t seed, const std::vector<double>& weights, int throws) {
    std::mt19937_64 engine(seed);
    std::discrete_distribution<std::size_t> cell(weights.begin(), weights.end());
    std::vector<double> counts(weights.size());
    for (int i = 0; i < throws; ++i) ++counts[cell(engine)];
    return counts;
}

// p values of a true expectation are uniform: of 400, the number below 0.05 is 20 +- 4.4, so 0 .. 45 with 5 sigma.
// Of an expectation 10 % wrong in each cell, nearly all are below: the non-central shift is 1e4 * 0.01 = 100.
TEST(ChiSquare, PValuesAreUniformIfTrueAndTinyIfNot) {
    std::vector<double> weights(20, 1.0), wrong(20);
    for (std::size_t i = 0; i < 20; ++i) wrong[i] = i % 2 ? 1.1 : 0.9;
    std::vector<double> expected(20, 500.0);
    int low = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        low += chi_square_test(thrown_counts(seed, weights, 10000), expected).p_value < 0.05;
        EXPECT_LT(chi_square_test(thrown_counts(seed, wrong, 10000), expected).p_value, 1e-3);
    }
    EXPECT_GT(low, 0);
    EXPECT_LT(low, 45);
}

TEST(Sidak, LevelsOfManyTestsMultiplyToTheFamily) {
    EXPECT_NEAR(std::pow(1 - sidak_level(0.01, 100), 100), 0.99, 1e-12);
    EXPECT_DOUBLE_EQ(sidak_level(0.05, 1), 0.05);
    EXPECT_NEAR(sidak_level(1e-4, 1000000), 1.00005e-10, 1e-14);
}

TEST(Sidak, NormalBoundInvertsTheTail) {
    EXPECT_NEAR(normal_bound(0.31731050786291415), 1.0, 1e-9);
    EXPECT_NEAR(normal_bound(0.0026997960632601866), 3.0, 1e-9);
}

}  // namespace
}  // namespace brewster
