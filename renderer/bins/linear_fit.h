#pragma once
#include <array>

#include "bins/outline.h"

namespace brewster {

/// Least squares on a cell whose surface has the given moments. For a density f on the surface with sums W = integral
/// f, M = integral f x, the best linear function is (W / A)(1 + slope . (x - mean)) with slope = C^-1 (M - W mean) / W.
class LinearFit {
  public:
    explicit LinearFit(const CellGeometry& geometry) : geometry_(&geometry) {
        // Slivers along an axis have no spread across it; the small term keeps their slope there at zero.
        constexpr double least_variance = 1e-7;
        const double xx = geometry.covariance[0] + least_variance, xy = geometry.covariance[1];
        const double yy = geometry.covariance[2] + least_variance;
        const double determinant = xx * yy - xy * xy;
        inverse_ = {yy / determinant, -xy / determinant, xx / determinant};
    }

    /// v . C^-1 v
    double square(const std::array<double, 2>& v) const {
        return inverse_[0] * v[0] * v[0] + 2 * inverse_[1] * v[0] * v[1] + inverse_[2] * v[1] * v[1];
    }

    /// Deviation of the first moments from those of a constant density.
    std::array<double, 2> deviation(double weight, const std::array<double, 2>& moments) const {
        return {moments[0] - weight * geometry_->mean[0], moments[1] - weight * geometry_->mean[1]};
    }

    std::array<double, 2> slope(double weight, const std::array<double, 2>& moments) const {
        if (weight <= 0) return {0, 0};
        const auto d = deviation(weight, moments);
        return {(inverse_[0] * d[0] + inverse_[1] * d[1]) / weight, (inverse_[1] * d[0] + inverse_[2] * d[1]) / weight};
    }

    /// Integral of the fitted function's square.
    double energy(double weight, const std::array<double, 2>& moments) const {
        return (weight * weight + square(deviation(weight, moments))) / geometry_->area;
    }

    /// Variance of the fit at a point, in units of the variance of its mean, for evenly spread photons.
    double variance_factor(const std::array<double, 2>& at) const {
        return 1 + square({at[0] - geometry_->mean[0], at[1] - geometry_->mean[1]});
    }

  private:
    const CellGeometry* geometry_;
    std::array<double, 3> inverse_{};
};

}  // namespace brewster
