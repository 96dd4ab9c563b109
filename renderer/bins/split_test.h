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

/// What the test's functions see of a cell beyond its linear fit: the integral of their part's square times the cell's
/// measure. Were it nothing but the noise of independent photons, that would be sum w^2 for each function on the mean.
/// `sum`: row of the test record -> its value.
template <int D>
struct Misfit {
    static constexpr int functions = 2 * D + RecordLayout<D>::pair_count;
    double energy = 0;

    template <class Sum>
    Misfit(const Sum& sum, double weight, const NullMoments<D>& null) {
        using Layout = RecordLayout<D>;
        for (int a = 0; a < D; ++a) {
            const auto i = static_cast<std::size_t>(a);
            const double slope = sum(Layout::moments + a) - weight * null.mean[i];
            const double curve = sum(Layout::legendre + a) - weight * null.legendre[i];
            const double step = sum(Layout::signs + a) - weight * null.sign[i] - 1.5 * slope;
            energy += 5 * curve * curve + 4 * step * step;
        }
        for (int pair = 0; pair < Layout::pair_count; ++pair) {
            const double twist =
                sum(Layout::products + pair) - weight * null.sign_product[static_cast<std::size_t>(pair)];
            energy += twist * twist;
        }
    }
};

/// Looks for what a linear cell cannot show: second Legendre moments, steps at the middle that a slope does not
/// explain, interactions of two axes (their per-axis projections may be flat). Under a uniform density the second
/// moment has variance V/5, the step V/4, the interaction V, with V = sum w^2. Nothing if the leaf has too few photons
/// or no test passes settings.split_z_squared.
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
    std::array<double, D> slope{};
    for (int a = 0; a < D; ++a) {
        const auto i = static_cast<std::size_t>(a);
        slope[i] = sum(Layout::moments + a) - weight * null.mean[i];
        consider(a, sum(Layout::legendre + a) - weight * null.legendre[i], squares / 5);
        consider(a, sum(Layout::signs + a) - weight * null.sign[i] - 1.5 * slope[i], squares / 4);
    }
    int pair = 0;
    for (int a = 0; a < D; ++a) {
        for (int b = a + 1; b < D; ++b, ++pair) {
            const int steeper =
                std::abs(slope[static_cast<std::size_t>(a)]) >= std::abs(slope[static_cast<std::size_t>(b)]) ? a : b;
            consider(steeper, sum(Layout::products + pair) - weight * null.sign_product[static_cast<std::size_t>(pair)],
                     squares);
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
            consider(a, sum(row + a) - side_weight * null.legendre[i], side_squares / 5);
            consider(a, sum(row + D + a) - side_weight * null.sign[i] - 1.5 * side_slope, side_squares / 4);
        }
    }
    if (best.z_squared <= settings.split_z_squared) return std::nullopt;
    return best;
}

}  // namespace brewster
