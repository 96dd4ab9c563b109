#include "optics/polarized_diffuse.h"

#include "base/check.h"

namespace brewster {
namespace {

/// 2 int R cos dcos. R falls steeply towards grazing incidence, over cosines of the order w = sqrt(n^2 - 1); in y with
/// c = w sinh y it is smooth at every n. Simpson's rule.
double by_quadrature(double n) {
    const double w = std::sqrt((n - 1) * (n + 1));
    if (w == 0) return 0;
    const double last = std::asinh(1 / w);
    const int steps = 20000;
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
        const double y = last * k / steps, c = std::min(w * std::sinh(y), 1.0);
        const double weight = k == 0 || k == steps ? 1 : (k % 2 == 1 ? 4 : 2);
        sum += weight * dielectric_interface(c, n).reflection.a * c * w * std::cosh(y);
    }
    return 2 * sum * last / (3 * steps);
}

}  // namespace

double external_reflectance(double n) {
    BREWSTER_CHECK(n >= 1, "external_reflectance needs n >= 1");
    if (n < 1.01) return by_quadrature(n);
    const double n2 = n * n, n4 = n2 * n2;
    const double minus = (n - 1) * (n + 1), plus = n2 + 1, product = minus * plus;
    return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * minus * minus / (plus * plus * plus) * std::log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / (plus * product) +
           8 * n4 * (n4 + 1) / (plus * product * product) * std::log(n);
}

}  // namespace brewster
