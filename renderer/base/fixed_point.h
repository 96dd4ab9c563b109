#pragma once
#include <cmath>
#include <cstdint>

namespace brewster {

/// Tallies are integers, so that sums do not depend on their order. One unit of photon weight is 2^30 quanta;
/// an int64 then holds 2^33 deposits of weight 1, far above what one batch brings, and Wide holds all batches.
using Quanta = std::int64_t;
__extension__ using Wide = __int128;

inline constexpr double quanta_per_weight = 0x1p30;

/// Rounds a weight to quanta, ties to even. |weight| must stay below 2^32.
inline Quanta to_quanta(float weight) {
    return std::llrint(static_cast<double>(weight) * quanta_per_weight);
}
inline Quanta to_quanta(double weight) {
    return std::llrint(weight * quanta_per_weight);
}

/// Back to a weight; exact up to 2^53 quanta, correctly rounded above.
inline double to_weight(Wide quanta) {
    return static_cast<double>(quanta) / quanta_per_weight;
}

}  // namespace brewster
