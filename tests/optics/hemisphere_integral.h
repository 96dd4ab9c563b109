#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "optics/vector.h"

namespace brewster {

/// Nodes and weights of Gauss-Legendre on [-1, 1] by Newton's method.
inline std::vector<std::array<double, 2>> gauss_legendre(int order) {
    std::vector<std::array<double, 2>> rule;
    for (int k = 0; k < order; ++k) {
        double x = std::cos(pi * (k + 0.75) / (order + 0.5)), derivative = 1;
        for (int step = 0; step < 50; ++step) {
            double p0 = 1, p1 = x;
            for (int n = 2; n <= order; ++n) {
                const double p2 = ((2 * n - 1) * x * p1 - (n - 1) * p0) / n;
                p0 = p1;
                p1 = p2;
            }
            derivative = order * (x * p1 - p0) / (x * x - 1);
            const double dx = p1 / derivative;
            x -= dx;
            if (std::abs(dx) < 1e-16) break;
        }
        rule.push_back({x, 2 / ((1 - x * x) * derivative * derivative)});
    }
    return rule;
}

/// Integral of several functions of r over the upper hemisphere, symmetric in azimuth, for a source at cos_i in the
/// half plane y = 0, x >= 0: composite Gauss-Legendre with panels that halve towards the mirror direction and the
/// horizon.
template <std::size_t count, class Function>
std::array<double, count> hemisphere_integral(double cos_i, Function function, int order = 12) {
    const auto rule = gauss_legendre(order);
    const double theta_i = std::acos(cos_i);
    std::vector<double> theta_breaks = {0, theta_i, pi / 2}, phi_breaks = {0, pi};
    for (int k = 1; k < 10; ++k) {
        if (theta_i > 0) theta_breaks.push_back(theta_i - theta_i * std::ldexp(1, -k));
        theta_breaks.push_back(theta_i + (pi / 2 - theta_i) * std::ldexp(1, -k));
        phi_breaks.push_back(pi * std::ldexp(1, -k));
        if (cos_i > 0.02) theta_breaks.push_back(pi / 2 * (1 - std::ldexp(1, -k)));
    }
    std::sort(theta_breaks.begin(), theta_breaks.end());
    std::sort(phi_breaks.begin(), phi_breaks.end());
    if (cos_i == 1) phi_breaks = {0, pi};
    std::array<double, count> sum{};
    for (std::size_t a = 1; a < theta_breaks.size(); ++a)
        for (const auto& [x, wx] : rule) {
            const double half = 0.5 * (theta_breaks[a] - theta_breaks[a - 1]),
                         theta = theta_breaks[a - 1] + half * (1 + x);
            if (half <= 0) continue;
            for (std::size_t b = 1; b < phi_breaks.size(); ++b)
                for (const auto& [y, wy] : rule) {
                    const double half_phi = 0.5 * (phi_breaks[b] - phi_breaks[b - 1]);
                    const double phi = phi_breaks[b - 1] + half_phi * (1 + y);
                    const double s = std::sin(theta);
                    const auto values =
                        function(Vector<double>{-s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
                    for (std::size_t j = 0; j < count; ++j) sum[j] += 2 * wx * half * wy * half_phi * s * values[j];
                }
        }
    return sum;
}

}  // namespace brewster
