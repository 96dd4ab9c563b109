#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace brewster {

/// Mean of independent repetitions (seeds, batches) and what their spread says of its error.
struct BatchMeans {
    double mean = 0;
    double standard_error = 0;  ///< of the mean
    int degrees = 0;            ///< repetitions less one

    /// |mean - truth| in standard errors.
    double t(double truth) const;
    /// Probability of a larger |t| if `truth` is true and the repetitions are normal (Student 1908).
    double p_value(double truth) const;
};

/// Of at least two repetitions.
BatchMeans batch_means(std::span<const double> repetitions);

/// The same of `run(seed)` for seeds first .. first + count - 1.
BatchMeans means_over_seeds(const std::function<double(std::uint64_t)>& run, std::uint64_t first, std::size_t count);

/// Probability that |t| of Student's distribution exceeds `t` >= 0: the incomplete beta function I_x(d/2, 1/2) at
/// x = d / (d + t^2) (Abramowitz and Stegun 26.7.1), by its continued fraction, to 1e-10.
double student_tail(double t, int degrees);

/// The |t| that is exceeded with probability `level`.
double student_bound(double level, int degrees);

}  // namespace brewster
