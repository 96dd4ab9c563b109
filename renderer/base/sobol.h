#pragma once
#include <cstdint>

#include "base/word_lanes.h"

namespace brewster {

inline constexpr unsigned sobol_dimensions = 8;

/// Point `index` of the Sobol sequence in dimension `dimension` < sobol_dimensions, as 32-bit fixed point
/// (direction numbers of Joe and Kuo 2008, new-joe-kuo-6), nested-uniform scrambled by `scramble`
/// (hash-based Owen scrambling: Laine and Karras 2011, Burley 2020). Indices wrap at 2^32.
std::uint32_t sobol_owen(std::uint32_t index, unsigned dimension, std::uint32_t scramble);
WordLanes sobol_owen(WordLanes index, unsigned dimension, WordLanes scramble);  ///< the same in lanes

/// A 32-bit hash that decorrelates scrambles of (seed, replica, dimension).
std::uint32_t scramble_of(std::uint64_t seed, std::uint32_t replica, std::uint32_t dimension);

}  // namespace brewster
