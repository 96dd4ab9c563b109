#pragma once
#include <cstddef>
#include <span>

namespace brewster {

/// Pearson's chi-square test of counts against expected counts.
struct ChiSquare {
    double statistic = 0;
    int degrees = 0;     ///< cells after pooling, minus one
    double p_value = 1;  ///< probability of a larger statistic if the expectation holds
};

/// Cells are pooled in order until each expects at least 5. The expectations must sum to the counts' sum.
ChiSquare chi_square_test(std::span<const double> counts, std::span<const double> expected);

/// Probability that a chi-square variable of `degrees` exceeds `x`: the upper incomplete gamma function Q(degrees/2,
/// x/2) (Abramowitz and Stegun 6.5.29, 6.5.31: series below, continued fraction above), to 1e-10.
double chi_square_tail(double x, int degrees);

/// Sidak (1967): the level of each of `tests` independent tests so that all together fail with probability `family`.
double sidak_level(double family, std::size_t tests);

/// The |z| that a normal variable exceeds on either side with probability `level`.
double normal_bound(double level);

}  // namespace brewster
