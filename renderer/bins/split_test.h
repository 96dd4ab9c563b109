#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "bins/bin_settings.h"
#include "bins/outline.h"
#include "bins/record.h"

namespace brewster {

/// What a uniform density on the part of the cell that is surface would give; zero on a full cell.
template <int D>
struct NullMoments {
    std::array<double, D> mean{}, legendre{}, sign{};
    std::array<double, RecordLayout<D>::pair_count> sign_product{};
};

template <int D>
NullMoments<D> null_moments(const CellGeometry& geometry) {
    NullMoments<D> null;
    for (std::size_t a = 0; a < 2; ++a) {
        null.mean[a] = geometry.mean[a];
        null.legendre[a] = geometry.legendre[a];
        null.sign[a] = geometry.sign[a];
    }
    null.sign_product[0] = geometry.sign_product;  // the pair (u, v) is the first
    return null;
}

struct SplitChoice {
    int axis = 0;
    double z_squared = 0;  ///< squared deviation from a linear cell, in variances
    double power = 0;      ///< sum of weights
};

/// What a cell holds beyond its linear fit, as the test sees it: second Legendre moments, steps at the middle that a slope
/// does not explain, interactions of two axes (their per-axis projections may be flat). Under a uniform density the second
/// moment has variance V/5, the step V/4, the interaction V, with V = sum w^2.
template <int D>
struct Deviations {
    static constexpr int functions = 2 * D + RecordLayout<D>::pair_count;
    static constexpr double curve_weight = 5, step_weight = 4;  // V over their variances
    std::array<double, D> slope{}, curve{}, step{};
    std::array<double, RecordLayout<D>::pair_count> twist{};

    /// `sum`: row of the test record -> its value; `weight`: all of the cell.
    template <class Sum>
    Deviations(const Sum& sum, double weight, const NullMoments<D>& null) {
        using Layout = RecordLayout<D>;
        for (int a = 0; a < D; ++a) {
            const auto i = static_cast<std::size_t>(a);
            slope[i] = sum(Layout::moments + a) - weight * null.mean[i];
            curve[i] = sum(Layout::legendre + a) - weight * null.legendre[i];
            step[i] = sum(Layout::signs + a) - weight * null.sign[i] - 1.5 * slope[i];
        }
        for (int pair = 0; pair < Layout::pair_count; ++pair) {
            const auto i = static_cast<std::size_t>(pair);
            twist[i] = sum(Layout::products + pair) - weight * null.sign_product[i];
        }
    }

    /// Integral of the square of that part of the density times the cell's measure. Were it nothing but the noise of
    /// independent photons, it would be V for each function on the mean.
    double energy() const {
        double sum = 0;
        for (const double c : curve) sum += curve_weight * c * c;
        for (const double s : step) sum += step_weight * s * s;
        for (const double t : twist) sum += t * t;
        return sum;
    }
};

/// Looks for the largest of the deviations. Nothing if the leaf has too few photons or none passes
/// settings.split_z_squared.
/// Side fields are tested by their second moments and steps alone, against the squares of their own bands.
template <int D>
std::optional<SplitChoice> choose_split(const RecordLayout<D>& layout, const CellSums& sums, const NullMoments<D>& null,
                                        const BinSettings& settings) {
    using Layout = RecordLayout<D>;
    const auto sum = [&](int row) { return to_weight(sums.test[static_cast<std::size_t>(row)]); };
    double weight = 0;
    for (int r = 0; r < replica_count; ++r) weight += sum(Layout::replicas + r);
    const double squares = sum(Layout::squares);
    if (weight <= 0 || weight * weight < settings.split_photons * squares) return std::nullopt;

    SplitChoice best;
    best.power = weight;
    const auto consider = [&](int axis, double deviation, double variance) {
        const double z_squared = variance > 0 ? deviation * deviation / variance : 0;
        if (z_squared > best.z_squared) {
            best.axis = axis;
            best.z_squared = z_squared;
        }
    };
    const Deviations<D> found(sum, weight, null);
    for (std::size_t a = 0; a < D; ++a) {
        consider(static_cast<int>(a), found.curve[a], squares / Deviations<D>::curve_weight);
        consider(static_cast<int>(a), found.step[a], squares / Deviations<D>::step_weight);
    }
    std::size_t pair = 0;
    for (std::size_t a = 0; a < D; ++a) {
        for (std::size_t b = a + 1; b < D; ++b, ++pair) {
            const std::size_t steeper = std::abs(found.slope[a]) >= std::abs(found.slope[b]) ? a : b;
            consider(static_cast<int>(steeper), found.twist[pair], squares);
        }
    }
    for (int side = 0; side < layout.side_fields; ++side) {
        // Band means of the estimate's sums; the mean of the squares is no less than the square of the mean.
        const auto band_mean = [&](int entry) {
            double total = 0;
            for (int band = 0; band < layout.bands; ++band) {
                const int channel = layout.side_field[static_cast<std::size_t>(side)] * layout.bands + band;
                total += to_weight(sums.estimate[static_cast<std::size_t>(channel * Layout::estimate_stride + entry)]);
            }
            return total / layout.bands;
        };
        const double side_weight = band_mean(0), side_squares = band_mean(1 + D);
        const int row = Layout::sides + side * Layout::side_stride;
        for (int a = 0; a < D; ++a) {
            const auto i = static_cast<std::size_t>(a);
            const double side_slope = band_mean(1 + a) - side_weight * null.mean[i];
            consider(a, sum(row + a) - side_weight * null.legendre[i], side_squares / Deviations<D>::curve_weight);
            consider(a, sum(row + D + a) - side_weight * null.sign[i] - 1.5 * side_slope,
                     side_squares / Deviations<D>::step_weight);
        }
    }
    if (best.z_squared <= settings.split_z_squared) return std::nullopt;
    return best;
}

}  // namespace brewster
