#pragma once
#include <bit>
#include <cstdint>

namespace brewster {

/// Tallies are integers, so that sums do not depend on their order. One unit of photon weight is 2^30 quanta;
/// an int64 then holds 2^33 deposits of weight 1, far above what one batch brings, and Wide holds all batches.
using Quanta = std::int64_t;
__extension__ using Wide = __int128;

inline constexpr double quanta_per_weight = 0x1p30;

/// Adding this to a double below 2^51 in size leaves its nearest integer in the low bits of the mantissa.
inline constexpr double rounding_magic = 0x1.8p52;

/// Rounds a weight to quanta, ties to even. |weight| must stay below 2^21. As integer instructions of any width do it.
inline Quanta to_quanta(double weight) {
    return std::bit_cast<Quanta>(weight * quanta_per_weight + rounding_magic) - std::bit_cast<Quanta>(rounding_magic);
}
inline Quanta to_quanta(float weight) {
    return to_quanta(static_cast<double>(weight));
}

/// Back to a weight; exact up to 2^53 quanta, correctly rounded above.
inline double to_weight(Wide quanta) {
    return static_cast<double>(quanta) / quanta_per_weight;
}

}  // namespace brewster
