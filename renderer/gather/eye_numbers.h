#pragma once
#include <array>
#include <cstdint>

#include "base/owen.h"

namespace brewster {

/// The random numbers of one draw: Owen-scrambled Sobol pairs, scrambled anew for every pixel and dimension.
struct EyeNumbers {
    std::uint32_t key = 0;    ///< of the pixel's sequence
    std::uint32_t index = 0;  ///< of the draw in it
};

/// Dimensions: where in the pixel; then at each vertex the point on the lamps, the facet, and the rest of a facet (or a
/// choice) with a second choice. Far beyond all of these: where a base's indirect light is gathered.
inline constexpr std::uint32_t place_dimension = 0;
inline constexpr std::uint32_t lamp_dimension(std::uint32_t vertex) {
    return 1 + 3 * vertex;
}
inline constexpr std::uint32_t facet_dimension(std::uint32_t vertex) {
    return 2 + 3 * vertex;
}
inline constexpr std::uint32_t choice_dimension(std::uint32_t vertex) {
    return 3 + 3 * vertex;
}
inline constexpr std::uint32_t exit_dimension(std::uint32_t vertex) {
    return 0x10000 + vertex;
}

/// Two numbers in [0, 1) of the draw `index` of a sequence.
template <class Real>
std::array<Real, 2> number_pair(const Word<Real>& key, const Word<Real>& index, std::uint32_t dimension) {
    using Words = Word<Real>;
    const auto point = sobol_pair(index, mixed_bits(key + Words(0x9e3779b9u * dimension)));
    const auto unit = [](const Words& word) { return number_of(word >> 8) * constant<Real>(0x1p-24); };
    return {unit(point[0]), unit(point[1])};
}

/// The key of a pixel's sequence; each pixel has several (replicas), so that their differences tell its error.
inline std::uint32_t sequence_key(std::uint64_t seed, std::uint32_t pixel, std::uint32_t replica) {
    const auto low = static_cast<std::uint32_t>(seed), high = static_cast<std::uint32_t>(seed >> 32);
    return mixed_bits(mixed_bits(mixed_bits(low) + high) ^ mixed_bits(2 * pixel + replica + 1));
}

}  // namespace brewster
