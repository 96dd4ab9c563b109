#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "bins/bin_settings.h"
#include "bins/record.h"

namespace brewster {

/// What a uniform density on the part of the cell that is surface would give; zero on a full cell.
template <int D>
struct NullMoments {
    std::array<double, D> mean{}, legendre{}, sign{};
    std::array<double, RecordLayout<D>::pair_count> sign_product{};
};

struct SplitChoice {
    int axis = 0;
    double z_squared = 0;  ///< squared deviation from a linear cell, in variances
    double power = 0;      ///< sum of weights
};

/// Looks for what a linear cell cannot show: second Legendre moments, steps at the middle that a slope does not
/// explain, interactions of two axes (their per-axis projections may be flat). Under a uniform density the second
/// moment has variance V/5, the step V/4, the interaction V, with V = sum w^2. Nothing if the leaf has too few photons
/// or no test passes settings.split_z_squared.
template <int D>
std::optional<SplitChoice> choose_split(const CellSums<D>& sums, const NullMoments<D>& null,
                                        const BinSettings& settings) {
    using Layout = RecordLayout<D>;
    Wide total = 0;
    for (int r = 0; r < replica_count; ++r) total += sums.test[static_cast<std::size_t>(Layout::replicas + r)];
    const double weight = to_weight(total);
    const double squares = to_weight(sums.test[Layout::squares]);
    if (weight <= 0 || weight * weight < settings.split_photons * squares) return std::nullopt;

    const auto sum = [&](int row) { return to_weight(sums.test[static_cast<std::size_t>(row)]); };
    SplitChoice best;
    best.power = weight;
    const auto consider = [&](int axis, double deviation, double variance) {
        const double z_squared = deviation * deviation / variance;
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
    if (best.z_squared <= settings.split_z_squared) return std::nullopt;
    return best;
}

}  // namespace brewster
