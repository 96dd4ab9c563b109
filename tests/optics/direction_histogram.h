#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/units.h"
#include "optics/random_light.h"
#include "optics/vector.h"

namespace brewster {

/// P(chi-square with `degrees` > x): the upper regularized incomplete gamma function, by series or continued fraction.
inline double chi_square_tail(double x, double degrees) {
    const double a = 0.5 * degrees, z = 0.5 * x;
    if (z <= 0) return 1;
    const double front = std::exp(a * std::log(z) - z - std::lgamma(a));
    if (z < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-16; ++n) sum += term *= z / (a + n);
        return 1 - front * sum;
    }
    double b = z + 1 - a, c = 1e300, d = 1 / b, f = d;
    for (int n = 1; n < 10000; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        f *= d * c;
        if (std::abs(d * c - 1) < 1e-16) break;
    }
    return front * f;
}

/// Upper hemisphere in cells of cos(theta) and phi, an odd number of each so that no border falls on the symmetry
/// planes, and one cell for everything else.
struct DirectionHistogram {
    static constexpr int rings = 31, sectors = 61;
    std::vector<double> cells = std::vector<double>(rings * sectors + 1, 0.0);

    void add(const Vector<double>& direction) {
        if (!(direction.z > 0)) {
            cells.back() += 1;
            return;
        }
        const double turn = std::atan2(direction.y, direction.x) / (2 * pi);
        const int ring = std::min(static_cast<int>(direction.z * rings), rings - 1);
        const int sector = std::min(static_cast<int>((turn - std::floor(turn)) * sectors), sectors - 1);
        cells[static_cast<std::size_t>(ring * sectors + sector)] += 1;
    }
};

/// Probability of each cell of DirectionHistogram under a density per solid angle: 10 x 10 midpoints a cell; 7 x 7 for a
/// fifth of the draws. Their error falls with the square of their number along a side and adds draws x error^2 to
/// chi-square: 10 / 5^(1/4) = 6.7 along a side keep that.
inline std::vector<double> cell_probabilities(const std::function<double(const Vector<double>&)>& density) {
    constexpr int n = light_test_scale == 1 ? 10 : 7, rings = DirectionHistogram::rings, sectors = DirectionHistogram::sectors;
    std::vector<double> probability(rings * sectors + 1, 0.0);
    double total = 0;
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            double sum = 0;
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b) {
                    const double z = (ring + (a + 0.5) / n) / rings, phi = 2 * pi * (sector + (b + 0.5) / n) / sectors;
                    const double s = std::sqrt((1 - z) * (1 + z));
                    sum += density({s * std::cos(phi), s * std::sin(phi), z});
                }
            sum *= 2 * pi / (rings * sectors * n * n);
            probability[static_cast<std::size_t>(ring * sectors + sector)] = sum;
            total += sum;
        }
    probability.back() = std::max(0.0, 1 - total);
    return probability;
}

/// p-value of Pearson's test; cells expected to hold fewer than 5 are pooled into one.
inline double chi_square_p(const std::vector<double>& observed, const std::vector<double>& probability) {
    double samples = 0, statistic = 0, pooled_observed = 0, pooled_expected = 0;
    for (const double count : observed) samples += count;
    int cells = 0;
    const auto add = [&](double count, double expected) {
        statistic += (count - expected) * (count - expected) / expected;
        ++cells;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double expected = samples * probability[i];
        if (expected >= 5) {
            add(observed[i], expected);
        } else {
            pooled_observed += observed[i];
            pooled_expected += expected;
        }
    }
    if (pooled_expected >= 5)
        add(pooled_observed, pooled_expected);
    else if (pooled_observed > 30)
        return 0;  // where fewer than 5 belong
    return chi_square_tail(statistic, cells - 1);
}

/// The level of each of `tests` tests that together reject a true hypothesis with probability 1e-4 (Sidak).
inline double sidak_level(int tests) {
    return 1 - std::pow(1 - 1e-4, 1.0 / tests);
}

}  // namespace brewster
