#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "bins/tree.h"

namespace brewster {

/// Adds one arrival of light to both records of a leaf. `weight`: per band, in units of photon weight; `direct`: a
/// photon's first hit; `replica`: photon index mod 8. The point must lie in the leaf.
template <int D>
inline void file_event(const BinTree<D>& tree, Tally<D>& tally, std::uint32_t leaf,
                       const typename BinTree<D>::Point& point, const glm::vec3& weight, bool direct,
                       std::uint32_t replica) {
    using Layout = RecordLayout<D>;
    const LeafFrame<D>& frame = tree.frame(leaf);
    std::array<float, D> x;
    for (std::size_t a = 0; a < D; ++a) x[a] = frame.coordinate(point[a], a);

    Quanta* estimate = tally.estimate(leaf) + (direct ? 0 : band_count * Layout::estimate_stride);
    for (int band = 0; band < band_count; ++band) {
        const float w = weight[band];
        estimate[0] += to_quanta(w);
        for (std::size_t a = 0; a < D; ++a) estimate[1 + a] += to_quanta(w * x[a]);
        estimate[1 + D] += to_quanta(w * w);
        estimate += Layout::estimate_stride;
    }

    const float w = (weight.x + weight.y + weight.z) * (1.0f / band_count);
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
    test[Layout::replicas + static_cast<int>(replica)] += to_quanta(w);
}

}  // namespace brewster
