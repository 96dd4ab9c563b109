#pragma once
#include <array>

#include "bins/tree.h"

namespace brewster {

/// Least squares on a cell whose surface has the given moments; directions, where there are any, fill their box evenly
/// and apart from position. For a density f on the cell with sums W = integral f, M = integral f x, the best linear
/// function is (W / measure)(1 + slope . (x - mean)) with slope = C^-1 (M - W mean) / W.
template <int D>
class LinearFit {
  public:
    using Coordinates = std::array<double, D>;

    explicit LinearFit(const Cell<D>& cell) : LinearFit(cell.geometry, cell_measure(cell)) {}
    LinearFit(const CellGeometry& geometry, double measure) : geometry_(&geometry), measure_(measure) {
        // Slivers along an axis have no spread across it; the small term keeps their slope there at zero.
        constexpr double least_variance = 1e-7;
        const double xx = geometry_->covariance[0] + least_variance, xy = geometry_->covariance[1];
        const double yy = geometry_->covariance[2] + least_variance;
        const double determinant = xx * yy - xy * xy;
        inverse_ = {yy / determinant, -xy / determinant, xx / determinant};
    }

    double measure() const { return measure_; }
    double mean(std::size_t axis) const { return axis < 2 ? geometry_->mean[axis] : 0.0; }

    /// C^-1 v
    Coordinates solve(const Coordinates& v) const {
        Coordinates s;
        s[0] = inverse_[0] * v[0] + inverse_[1] * v[1];
        s[1] = inverse_[1] * v[0] + inverse_[2] * v[1];
        for (std::size_t a = 2; a < D; ++a) s[a] = 3 * v[a];
        return s;
    }
    /// v . C^-1 v
    double square(const Coordinates& v) const {
        const Coordinates s = solve(v);
        double sum = 0;
        for (std::size_t a = 0; a < D; ++a) sum += v[a] * s[a];
        return sum;
    }

    /// Deviation of the first moments from those of a constant density.
    Coordinates deviation(double weight, const Coordinates& moments) const {
        Coordinates d;
        for (std::size_t a = 0; a < D; ++a) d[a] = moments[a] - weight * mean(a);
        return d;
    }

    /// W times the slope of the fit.
    Coordinates weighted_slope(double weight, const Coordinates& moments) const {
        return solve(deviation(weight, moments));
    }

    /// Integral of the fitted function's square.
    double energy(double weight, const Coordinates& moments) const {
        return (weight * weight + square(deviation(weight, moments))) / measure_;
    }

    /// Variance of the fit at a point, in units of the variance of its mean, for evenly spread photons.
    double variance_factor(Coordinates at) const {
        for (std::size_t a = 0; a < D; ++a) at[a] -= mean(a);
        return 1 + square(at);
    }

  private:
    const CellGeometry* geometry_;
    double measure_;
    std::array<double, 3> inverse_{};
};

}  // namespace brewster
