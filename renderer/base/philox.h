#pragma once
#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace brewster {

/// Four independent 32-bit random words for (seed, photon, bounce, draw): Philox4x32-10
/// (Salmon et al. 2011, doi:10.1145/2063384.2063405). Any photon can be replayed from its index alone.
inline std::array<std::uint32_t, 4> philox(std::uint64_t seed, std::uint64_t photon, std::uint32_t bounce,
                                           std::uint32_t draw) {
    const r123::Philox4x32::ctr_type counter = {
        {static_cast<std::uint32_t>(photon), static_cast<std::uint32_t>(photon >> 32), bounce, draw}};
    const r123::Philox4x32::key_type key = {{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const r123::Philox4x32::ctr_type words = r123::Philox4x32{}(counter, key);
    return {words[0], words[1], words[2], words[3]};
}

/// The upper 24 bits of a word as a float in [0, 1): every value exact, 1 never reached.
inline float unit_float(std::uint32_t word) {
    return static_cast<float>(word >> 8) * 0x1p-24f;
}

}  // namespace brewster
