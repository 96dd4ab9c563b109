#include "statistics/chi_square.h"

#include <cmath>
#include <stdexcept>

namespace brewster {
namespace {

constexpr double least_expected = 5;

// P(a, x) by its series; for x < a + 1.
double lower_gamma(double a, double x) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < 10000 && term > 1e-14 * sum; ++n) sum += term *= x / (a + n);
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Q(a, x) by Lentz's continued fraction; for x >= a + 1.
double upper_gamma(double a, double x) {
    double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
    for (int n = 1; n < 10000; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-14) break;
    }
    return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double chi_square_tail(double x, int degrees) {
    const double a = 0.5 * degrees, half = 0.5 * x;
    if (half <= 0) return 1;
    return half < a + 1 ? 1 - lower_gamma(a, half) : upper_gamma(a, half);
}

ChiSquare chi_square_test(std::span<const double> counts, std::span<const double> expected) {
    if (counts.size() != expected.size()) throw std::invalid_argument("counts and expectations differ in number");
    double total_count = 0, total_expected = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        total_count += counts[i];
        total_expected += expected[i];
    }
    if (std::abs(total_count - total_expected) > 1e-3 * total_count)
        throw std::invalid_argument("expectations sum to another number than the counts");

    ChiSquare result;
    double count = 0, expect = 0;
    int cells = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        count += counts[i];
        expect += expected[i];
        total_expected -= expected[i];
        // What is left must fill another cell, or it joins this one.
        if (expect < least_expected || (total_expected < least_expected && i + 1 < counts.size())) continue;
        result.statistic += (count - expect) * (count - expect) / expect;
        count = expect = 0;
        ++cells;
    }
    result.degrees = cells - 1;
    if (result.degrees < 1) throw std::invalid_argument("fewer than two cells expect 5 counts");
    result.p_value = chi_square_tail(result.statistic, result.degrees);
    return result;
}

double sidak_level(double family, std::size_t tests) {
    return -std::expm1(std::log1p(-family) / static_cast<double>(tests));
}

double normal_bound(double level) {
    double low = 0, high = 40;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > level ? low : high) = middle;
    }
    return low;
}

}  // namespace brewster
