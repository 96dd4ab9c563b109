#pragma once
#include <array>
#include <functional>

#include "optics/poisson_lobes.h"
#include "optics/polarized_diffuse.h"

namespace brewster {

/// Directional albedo of model V: reflected power = unpolarized S0 + s_minus_p S1 in the s frame of the mean surface;
/// by reciprocity (unpolarized, s_minus_p) is also what light from everywhere shows at that angle.
struct DirectionalAlbedo {
    double unpolarized, s_minus_p;
};

/// By Gauss-Legendre in the slopes that the ray sees; panels of 12 nodes, error about 1e-4 with 1 panel, 1e-6 with 4.
/// n - i k the relative index (k = 0: dielectric of n above or below 1), m > 0, cos_theta in (0, 1].
DirectionalAlbedo directional_albedo(double cos_theta, double n, double k, double m, int panels);

/// The same of model E1R over a dielectric of index n, its mirror part included, at one wavelength.
DirectionalAlbedo directional_albedo(double cos_theta, double n, const OrderRules& rules,
                                     const KirchhoffSurface<double, 1>& surface, int panels);

/// The directional albedo of one rough dielectric interface, tabulated for the photon loop, and the base under it:
/// entry row and exit column (1 - E, -E1), so that reflected + base = 1 for rho = 1 and both polarizations.
class RoughInterface {
  public:
    RoughInterface(double n, double m);                                                             ///< model V
    RoughInterface(double n, const OrderRules& rules, const KirchhoffSurface<double, 1>& surface);  ///< model E1R

    double external_reflectance() const { return external_; }  ///< Fe = 2 int E cos dcos, of the table itself
    double internal_reflectance() const { return 1 - (1 - external_) / (n_ * n_); }

    /// Cubic through four rows; within 1e-6 of the integral above cos_theta = 1e-3.
    template <class Real>
    Passage<Real> passage(const Real& cos_theta) const {
        const Real position = sqrt(cos_theta) * constant<Real>(rows - 1);
        const Real index = min(max(floor(position), Real(1)), constant<Real>(rows - 3));
        const Real t = position - index;  // outside [0, 1] in the first and last interval
        const Real before = t * (t - 1) * (t - 2) * constant<Real>(-1.0 / 6),
                   at = (t + 1) * (t - 1) * (t - 2) * constant<Real>(0.5);
        const Real next = (t + 1) * t * (t - 2) * constant<Real>(-0.5),
                   after = (t + 1) * t * (t - 1) * constant<Real>(1.0 / 6);
        const auto r0 = read_row<Real>(table_.data(), index - 1), r1 = read_row<Real>(table_.data(), index);
        const auto r2 = read_row<Real>(table_.data(), index + 1), r3 = read_row<Real>(table_.data(), index + 2);
        const auto blend = [&](std::size_t j) {
            return fma(before, r0[j], fma(at, r1[j], fma(next, r2[j], after * r3[j])));
        };
        return {blend(0), blend(1)};
    }

  private:
    RoughInterface(double n, const std::function<DirectionalAlbedo(double)>& albedo_at);

    static constexpr int rows = 129;  // evenly in sqrt(cos_theta): albedos are steep towards grazing incidence
    std::array<std::array<float, 2>, rows> table_;  // 1 - E, -E1
    double n_, external_;
};

}  // namespace brewster
