#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/rows.h"
#include "bins/imprint.h"
#include "bins/tree.h"

namespace brewster {

/// One arrival of light at a leaf, in fields that stand together in the records.
struct Arrival {
    int first_field = 0;
    int first_side = 0;  ///< the first field is the main light, those behind it are side fields from this one on
    std::span<const float> weights;  ///< per field and band, in units of photon weight
    std::uint32_t replica = 0;       ///< photon index mod 8
};

/// Adds an arrival to both records of a leaf. The point must lie in the leaf.
template <int D>
inline void file_event(const BinTree<D>& tree, Tally<D>& tally, std::uint32_t leaf,
                       const typename BinTree<D>::Point& point, const Arrival& arrival) {
    const LeafFrame<D>& frame = tree.frame(leaf);
    const int bands = tree.layout().bands;
    std::array<float, 4> x{};
    for (std::size_t a = 0; a < D; ++a) x[a] = frame.coordinate(point[a], a);
    const ImprintPlace place{static_cast<int>(arrival.weights.size()) / bands, arrival.first_field, arrival.first_side,
                             arrival.replica};
    std::array<float, static_cast<std::size_t>(RecordLayout<D>::most_fields * band_count)> weights{};
    std::copy(arrival.weights.begin(), arrival.weights.end(), weights.begin());
    const auto rows = tally.touch(leaf);
    add_imprint<D>(weights.data(), x.data(), place, bands, rows.estimate, rows.test);
}

/// Cell coordinates of a point in its leaf, in lanes.
template <int D>
std::array<FloatLanes, D> leaf_coordinates(const BinTree<D>& tree, WordLanes leaf,
                                           const std::array<WordLanes, D>& point) {
    std::array<std::uint32_t, lane_count> leaves;
    store(leaf, leaves.data());
    constexpr std::size_t rows = sizeof(LeafFrame<D>) / sizeof(Row);
    std::array<FloatLanes, rows * row_size> frame;
    for (std::size_t row = 0; row < rows; ++row) {
        const Columns columns = load_columns([&](int lane) {
            return reinterpret_cast<const float*>(&tree.frame(leaves[static_cast<std::size_t>(lane)])) + row * row_size;
        });
        for (std::size_t j = 0; j < row_size; ++j) frame[row * row_size + j] = columns[j];
    }
    std::array<FloatLanes, D> x;
    for (std::size_t a = 0; a < D; ++a)
        x[a] = (number_of(point[a] - words_of(frame[a])) - frame[D + a]) * frame[2 * D + a];
    return x;
}

}  // namespace brewster
