#pragma once
#include <cstdint>

#include "base/owen.h"

namespace brewster {

/// Two numbers in [0, 1).
struct NumberPair {
    float x = 0, y = 0;
};

/// The random numbers of one draw: Owen-scrambled Sobol pairs, scrambled anew for every pixel and dimension.
struct EyeNumbers {
    std::uint32_t key = 0;    ///< of the pixel's sequence
    std::uint32_t index = 0;  ///< of the draw in it

    NumberPair pair(std::uint32_t dimension) const {
        const auto point = sobol_pair(index, mixed_bits(key + 0x9e3779b9u * dimension));
        return {static_cast<float>(point[0] >> 8) * 0x1p-24f, static_cast<float>(point[1] >> 8) * 0x1p-24f};
    }

    /// Dimensions: where in the pixel; then at each vertex the point on the lamps, the facet, and the rest of a facet
    /// (or a choice) with a second choice.
    NumberPair place() const { return pair(0); }
    NumberPair lamp(std::uint32_t vertex) const { return pair(1 + 3 * vertex); }
    NumberPair facet(std::uint32_t vertex) const { return pair(2 + 3 * vertex); }
    NumberPair choices(std::uint32_t vertex) const { return pair(3 + 3 * vertex); }
};

/// The key of a pixel's sequence; each pixel has several (replicas), so that their differences tell its error.
inline std::uint32_t sequence_key(std::uint64_t seed, std::uint32_t pixel, std::uint32_t replica) {
    const auto low = static_cast<std::uint32_t>(seed), high = static_cast<std::uint32_t>(seed >> 32);
    return mixed_bits(mixed_bits(mixed_bits(low) + high) ^ mixed_bits(2 * pixel + replica + 1));
}

}  // namespace brewster
