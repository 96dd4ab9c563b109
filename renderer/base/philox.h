#pragma once
#include <Random123/philox.h>

#include <array>
#include <cstdint>

#include "base/word_lanes.h"

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

/// The same for a batch of photons and bounces.
inline std::array<WordLanes, 4> philox(std::uint64_t seed, WordLanes photon_low, WordLanes photon_high,
                                       WordLanes bounce, std::uint32_t draw) {
    auto key_low = static_cast<std::uint32_t>(seed), key_high = static_cast<std::uint32_t>(seed >> 32);
    std::array<WordLanes, 4> x = {photon_low, photon_high, bounce, WordLanes(draw)};
    for (int round = 0; round < 10; ++round) {
        const ProductLanes a = wide_product(x[0], 0xd2511f53u), b = wide_product(x[2], 0xcd9e8d57u);
        x = {b.high ^ x[1] ^ WordLanes(key_low), b.low, a.high ^ x[3] ^ WordLanes(key_high), a.low};
        key_low += 0x9e3779b9u;
        key_high += 0xbb67ae85u;
    }
    return x;
}

/// The upper 24 bits of a word as a float in [0, 1): every value exact, 1 never reached.
inline float unit_float(std::uint32_t word) {
    return static_cast<float>(word >> 8) * 0x1p-24f;
}
inline FloatLanes unit_float(WordLanes word) {
    return number_of(word >> 8) * FloatLanes(0x1p-24f);
}

}  // namespace brewster
