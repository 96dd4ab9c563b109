#pragma once
#include <array>
#include <cstdint>
#include <span>

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
    using Layout = RecordLayout<D>;
    const LeafFrame<D>& frame = tree.frame(leaf);
    const int bands = tree.layout().bands;
    std::array<float, D> x;
    for (std::size_t a = 0; a < D; ++a) x[a] = frame.coordinate(point[a], a);

    Quanta* estimate = tally.estimate(leaf) + arrival.first_field * bands * Layout::estimate_stride;
    for (const float w : arrival.weights) {
        estimate[0] += to_quanta(w);
        for (std::size_t a = 0; a < D; ++a) estimate[1 + a] += to_quanta(w * x[a]);
        estimate[1 + D] += to_quanta(w * w);
        estimate += Layout::estimate_stride;
    }

    const float share = 1.0f / static_cast<float>(bands);
    const auto band_mean = [&](std::size_t field) {
        float sum = 0;
        for (int band = 0; band < bands; ++band)
            sum += arrival.weights[field * static_cast<std::size_t>(bands) + static_cast<std::size_t>(band)];
        return sum * share;
    };
    const float w = band_mean(0);
    Quanta* test = tally.test(leaf);
    test[Layout::squares] += to_quanta(w * w);
    int pair = 0;
    for (std::size_t a = 0; a < D; ++a) {
        test[static_cast<std::size_t>(Layout::moments) + a] += to_quanta(w * x[a]);
        test[static_cast<std::size_t>(Layout::legendre) + a] += to_quanta(w * (1.5f * x[a] * x[a] - 0.5f));
        test[static_cast<std::size_t>(Layout::signs) + a] += to_quanta(x[a] < 0 ? -w : w);
        for (std::size_t b = a + 1; b < D; ++b, ++pair)
            test[Layout::products + pair] += to_quanta((x[a] < 0) != (x[b] < 0) ? -w : w);
    }
    test[Layout::replicas + static_cast<int>(arrival.replica)] += to_quanta(w);

    Quanta* side = test + Layout::sides + arrival.first_side * Layout::side_stride;
    const std::size_t fields = arrival.weights.size() / static_cast<std::size_t>(bands);
    for (std::size_t field = 1; field < fields; ++field, side += Layout::side_stride) {
        const float s = band_mean(field);
        for (std::size_t a = 0; a < D; ++a) {
            side[a] += to_quanta(s * (1.5f * x[a] * x[a] - 0.5f));
            side[D + a] += to_quanta(x[a] < 0 ? -s : s);
        }
    }
}

}  // namespace brewster
