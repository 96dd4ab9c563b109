#include "statistics/batch_means.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace brewster {
namespace {

// The continued fraction of I_x(a, b) by Lentz's method (Abramowitz and Stegun 26.5.8); for x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1);
    d = 1 / (std::abs(d) < tiny ? tiny : d);
    double h = d;
    for (int m = 1; m < 10000; ++m) {
        for (const double term : {m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                                  -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))}) {
            d = 1 + term * d;
            d = 1 / (std::abs(d) < tiny ? tiny : d);
            c = 1 + term / c;
            if (std::abs(c) < tiny) c = tiny;
            h *= c * d;
        }
        if (std::abs(c * d - 1) < 1e-14) break;
    }
    return h;
}

double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(a, b, x) / a;
    return 1 - front * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace

double BatchMeans::t(double truth) const {
    const double difference = std::abs(mean - truth);
    if (difference == 0) return 0;
    return standard_error > 0 ? difference / standard_error : std::numeric_limits<double>::infinity();
}

double BatchMeans::p_value(double truth) const {
    return student_tail(t(truth), degrees);
}

BatchMeans batch_means(std::span<const double> repetitions) {
    if (repetitions.size() < 2) throw std::invalid_argument("fewer than two repetitions have no spread");
    const double n = static_cast<double>(repetitions.size());
    BatchMeans result;
    for (const double x : repetitions) result.mean += x / n;
    double squares = 0;
    for (const double x : repetitions) squares += (x - result.mean) * (x - result.mean);
    result.standard_error = std::sqrt(squares / (n * (n - 1)));
    result.degrees = static_cast<int>(repetitions.size()) - 1;
    return result;
}

BatchMeans means_over_seeds(const std::function<double(std::uint64_t)>& run, std::uint64_t first, std::size_t count) {
    std::vector<double> repetitions;
    for (std::uint64_t seed = first; seed < first + count; ++seed) repetitions.push_back(run(seed));
    return batch_means(repetitions);
}

double student_tail(double t, int degrees) {
    if (degrees < 1 || !(t >= 0)) throw std::invalid_argument("t below zero or no degree of freedom");
    if (std::isinf(t)) return 0;
    return incomplete_beta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

double student_bound(double level, int degrees) {
    double low = 0, high = 1;
    while (student_tail(high, degrees) > level) high *= 2;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (student_tail(middle, degrees) > level ? low : high) = middle;
    }
    return low;
}

}  // namespace brewster
