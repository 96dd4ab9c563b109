#include "statistics/batch_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "statistics/chi_square.h"

namespace brewster {
namespace {

// Closed forms: one degree 1 - (2/pi) atan t; two degrees 1 - t / sqrt(2 + t^2).
TEST(Student, TailHasItsClosedForms) {
    for (const double t : {0.0, 0.01, 0.5, 1.0, 3.0, 40.0}) {
        EXPECT_NEAR(student_tail(t, 1), 1 - 2 / std::numbers::pi * std::atan(t), 1e-12) << t;
        EXPECT_NEAR(student_tail(t, 2), 1 - t / std::sqrt(2 + t * t), 1e-12) << t;
    }
    EXPECT_NEAR(student_tail(3.0, 1000000), std::erfc(3.0 / std::sqrt(2.0)), 1e-7);  // the normal limit
    EXPECT_EQ(student_tail(INFINITY, 3), 0);
    EXPECT_THROW(student_tail(1, 0), std::invalid_argument);
}

TEST(Student, BoundInvertsTheTail) {
    EXPECT_NEAR(student_bound(0.05, 10), 2.228138852, 1e-6);  // of every printed table
    EXPECT_NEAR(student_bound(0.01, 4), 4.604094871, 1e-6);
    EXPECT_NEAR(student_tail(student_bound(1e-5, 7), 7), 1e-5, 1e-12);
}

TEST(BatchMeans, MeanAndErrorOfTheMean) {
    const std::vector<double> numbers = {1, 2, 3, 6};
    const BatchMeans means = batch_means(numbers);
    EXPECT_DOUBLE_EQ(means.mean, 3);
    EXPECT_DOUBLE_EQ(means.standard_error, std::sqrt(14.0 / 12));
    EXPECT_EQ(means.degrees, 3);
    EXPECT_DOUBLE_EQ(means.t(1), 2 / std::sqrt(14.0 / 12));
    EXPECT_THROW(batch_means(std::vector<double>{1}), std::invalid_argument);
}

TEST(BatchMeans, WithoutSpreadOnlyTheTruthPasses) {
    const BatchMeans means = batch_means(std::vector<double>{2, 2, 2});
    EXPECT_EQ(means.p_value(2), 1);
    EXPECT_EQ(means.p_value(2.1), 0);
}

// p values under the truth are uniform: their chi-square over ten cells passes at 1e-4. A truth off by one standard
// deviation is found: with eight repetitions t has a mean of sqrt(8), so small p values pile up and the test fails.
TEST(BatchMeans, PValuesAreUniformIfTrue) {
    std::vector<double> counts(10), off(10);
    const std::vector<double> expected(10, 200.0);
    for (std::uint64_t trial = 0; trial < 2000; ++trial) {
        std::mt19937_64 engine(trial);
        std::normal_distribution<double> normal(5, 1);
        const BatchMeans means = means_over_seeds([&](std::uint64_t) { return normal(engine); }, 1, 8);
        ++counts[static_cast<std::size_t>(std::min(9.0, 10 * means.p_value(5)))];
        ++off[static_cast<std::size_t>(std::min(9.0, 10 * means.p_value(6)))];
    }
    EXPECT_GT(chi_square_test(counts, expected).p_value, 1e-4);
    EXPECT_LT(chi_square_test(off, expected).p_value, 1e-12);
}

}  // namespace
}  // namespace brewster
