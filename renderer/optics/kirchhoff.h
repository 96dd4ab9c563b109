#pragma once
#include <cmath>

#include "base/units.h"
#include "optics/lambert_w.h"
#include "optics/vector.h"

/// Scattering by a Gaussian surface in the Kirchhoff approximation (Beckmann 1963; thesis 6.42, 6.57, 7.26).
/// The reference that the engine's model (poisson_lobes.h) is compared with: double, not for the photon loop.
namespace brewster {

namespace kirchhoff_detail {

/// m ln(m/g) + g - m without cancellation (Loader 2000, the deviance of a Poisson law).
inline double deviance(double m, double g) {
    if (std::abs(m - g) >= 0.1 * (m + g)) return m * std::log(m / g) + g - m;
    const double v = (m - g) / (m + g);
    double sum = (m - g) * v, term = 2 * m * v;
    for (int j = 1; j < 1000; ++j) {
        term *= v * v;
        const double next = sum + term / (2 * j + 1);
        if (next == sum) break;
        sum = next;
    }
    return sum;
}

/// ln of the peak term for large real m, the rest of Stirling's formula included.
inline double log_term(double m, double g, double c) {
    const double inv = 1 / m, inv2 = inv * inv;
    const double stirling = inv * (1.0 / 12 - inv2 * (1.0 / 360 - inv2 * (1.0 / 1260 - inv2 / 1680)));
    return -deviance(m, g) - stirling - 1.5 * std::log(m) - c * inv - 0.5 * std::log(2 * pi);
}

}  // namespace kirchhoff_detail

/// ln f, f(g, c) = sum over m >= 1 of g^m e^-g/(m! m) e^(-c/m); g > 0, c >= 0. Absolute error below
/// 4.5e-15 (1 + |ln f|) for g in [1e-12, 1e6] and c/g up to 1000. Sums outwards from the largest term at
/// m = g exp(W(2c/g^2)/2): all integers where that is below 100, else with a stride of 0.7 widths, where the trapezoid
/// of a near-Gaussian is exact to 1e-17.
inline double log_kirchhoff_series(double g, double c) {
    using namespace kirchhoff_detail;
    const double peak = c > 0 ? g * std::exp(0.5 * lambert_w_of_log(std::log(2 * c) - 2 * std::log(g))) : g;
    if (peak < 100) {
        const double start = std::max(1.0, std::floor(peak));
        double sum = 1, power = 1;
        for (double m = start + 1;; ++m) {
            power *= g / m;
            const double term = power * (start / m) * std::exp(c * (m - start) / (m * start));
            sum += term;
            if (term < 1e-17 * sum && m > peak) break;
        }
        power = 1;
        for (double m = start - 1; m >= 1; --m) {
            power *= (m + 1) / g;
            const double term = power * (start / m) * std::exp(c * (m - start) / (m * start));
            sum += term;
            if (term < 1e-17 * sum) break;
        }
        return start * std::log(g) - g - std::lgamma(start + 1) - std::log(start) - c / start + std::log(sum);
    }
    const double width = 1 / std::sqrt(1 / peak + 2 * c / (peak * peak * peak)), stride = 0.7 * width;
    const double scale = log_term(peak, g, c);
    double sum = 1;
    for (const double direction : {-1.0, 1.0})
        for (int j = 1; j < 200; ++j) {
            const double m = peak + direction * j * stride;
            if (m < 1) break;
            const double term = std::exp(log_term(m, g, c) - scale);
            sum += term;
            if (term < 1e-17 * sum) break;
        }
    return scale + std::log(stride * sum);
}

inline double kirchhoff_series(double g, double c) {
    return std::exp(log_kirchhoff_series(g, c));
}

/// The diffuse lobe per solid angle and incident power, F = 1 and without shadowing (BRDF times cos_r):
/// v^4 tau^2/(16 pi v_z^2 cos_i) f(g, c), v = k (i + r), g = (sigma v_z)^2, c = v_xy^2 tau^2/4 (thesis 7.26).
/// sigma and tau in wavelengths; i and r unit, above the surface z = 0. The rest, e^-g, is the mirror's.
inline double kirchhoff_lobe(const Vector<double>& i, const Vector<double>& r, double sigma, double tau) {
    const double k = 2 * pi;
    const Vector<double> v = k * (i + r);
    const double v2 = dot(v, v), vz2 = v.z * v.z, g = sigma * sigma * vz2;
    if (g < 1e-300) return 0;
    return v2 * v2 * tau * tau / (16 * pi * vz2 * i.z) * kirchhoff_series(g, (v.x * v.x + v.y * v.y) * tau * tau / 4);
}

/// g at the mirror direction: (4 pi sigma cos_i / lambda)^2, sigma in wavelengths. The mirror's share is e^-g.
inline double specular_g(double sigma, double cos_i) {
    return std::pow(4 * pi * sigma * cos_i, 2);
}

}  // namespace brewster
