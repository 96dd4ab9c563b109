#pragma once
#include <cmath>
#include <optional>

#include "bins/light_sums.h"
#include "bins/split_test.h"

/// The split rule of the 1997 method, kept to compare with: a bin that counts more in one half than in the other, by
/// more than three standard deviations, along any parameter, is cut in two there. It is blind to what both halves hold
/// alike, such as a lobe in the middle. (The thesis names no threshold; three is what it is said to have used.)
namespace brewster {

inline constexpr double least_counted = 16, half_z_squared = 9;

/// Like choose_split, of the band mean alone.
template <int D>
std::optional<SplitChoice> choose_half(const CellSums& sums, const NullMoments<D>& null) {
    using Layout = RecordLayout<D>;
    const auto sum = [&](int row) { return to_weight(sums.test[static_cast<std::size_t>(row)]); };
    SplitChoice best;
    for (int r = 0; r < replica_count; ++r) best.power += sum(Layout::replicas + r);
    const double squares = sum(Layout::squares);
    if (best.power <= 0 || best.power * best.power < least_counted * squares) return std::nullopt;
    for (int a = 0; a < D; ++a) {
        const double difference = sum(Layout::signs + a) - best.power * null.sign[static_cast<std::size_t>(a)];
        const double z_squared = difference * difference / squares;
        if (z_squared <= best.z_squared) continue;
        best.axis = a;
        best.z_squared = z_squared;
    }
    if (best.z_squared <= half_z_squared) return std::nullopt;
    return best;
}

/// Whether the halves have counted as much since the split as a test asks for; until then their parent is shown.
template <int D>
bool halves_are_known(const FieldSums<D>& low, const FieldSums<D>& high) {
    double weight = 0, squares = 0;
    for (std::size_t band = 0; band < band_count; ++band) {
        weight += low.weight[band] + high.weight[band];
        squares += low.squares[band] + high.squares[band];
    }
    return weight * weight >= least_counted * band_count * squares;
}

}  // namespace brewster
