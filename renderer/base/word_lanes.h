#pragma once
#include <immintrin.h>

#include <array>
#include <bit>
#include <cstdint>

#include "base/lanes.h"

/// The integer half of the SIMD seam: 32-bit words in lanes, beside the floats of lanes.h.
namespace brewster {

struct WordLanes {
    __m256i bits{};

    WordLanes() = default;
    explicit WordLanes(__m256i from) : bits(from) {}
    explicit WordLanes(std::uint32_t everywhere) : bits(_mm256_set1_epi32(static_cast<int>(everywhere))) {}

    friend WordLanes operator+(WordLanes a, WordLanes b) { return WordLanes(_mm256_add_epi32(a.bits, b.bits)); }
    friend WordLanes operator-(WordLanes a, WordLanes b) { return WordLanes(_mm256_sub_epi32(a.bits, b.bits)); }
    friend WordLanes operator*(WordLanes a, WordLanes b) { return WordLanes(_mm256_mullo_epi32(a.bits, b.bits)); }
    friend WordLanes operator&(WordLanes a, WordLanes b) { return WordLanes(_mm256_and_si256(a.bits, b.bits)); }
    friend WordLanes operator|(WordLanes a, WordLanes b) { return WordLanes(_mm256_or_si256(a.bits, b.bits)); }
    friend WordLanes operator^(WordLanes a, WordLanes b) { return WordLanes(_mm256_xor_si256(a.bits, b.bits)); }
    friend WordLanes operator<<(WordLanes a, int by) { return WordLanes(_mm256_slli_epi32(a.bits, by)); }
    friend WordLanes operator>>(WordLanes a, int by) { return WordLanes(_mm256_srli_epi32(a.bits, by)); }
};

/// The type of a 32-bit word beside a Real.
template <class Real>
struct WordOf {
    using type = std::uint32_t;
};
template <>
struct WordOf<FloatLanes> {
    using type = WordLanes;
};
template <class Real>
using Word = typename WordOf<Real>::type;

inline WordLanes words_of(FloatLanes x) {
    return WordLanes(_mm256_castps_si256(static_cast<__m256>(x)));
}
inline std::uint32_t words_of(float x) {
    return std::bit_cast<std::uint32_t>(x);
}
inline FloatLanes floats_of(WordLanes x) {
    return FloatLanes(_mm256_castsi256_ps(x.bits));
}
inline float floats_of(std::uint32_t x) {
    return std::bit_cast<float>(x);
}

inline LaneMask equal(WordLanes a, WordLanes b) {
    return std::bit_cast<LaneMask>(_mm256_cmpeq_epi32(a.bits, b.bits));
}
inline bool equal(std::uint32_t a, std::uint32_t b) {
    return a == b;
}
/// a < b of words below 2^31.
inline LaneMask below(WordLanes a, WordLanes b) {
    return std::bit_cast<LaneMask>(_mm256_cmpgt_epi32(b.bits, a.bits));
}
inline bool below(std::uint32_t a, std::uint32_t b) {
    return a < b;
}
inline LaneMask has_top_bit(WordLanes x) {
    return std::bit_cast<LaneMask>(_mm256_srai_epi32(x.bits, 31));
}
inline bool has_top_bit(std::uint32_t x) {
    return x >> 31 != 0;
}
inline WordLanes select(const LaneMask& mask, WordLanes a, WordLanes b) {
    return WordLanes(_mm256_blendv_epi8(b.bits, a.bits, std::bit_cast<__m256i>(mask)));
}
inline std::uint32_t select(bool mask, std::uint32_t a, std::uint32_t b) {
    return mask ? a : b;
}

/// The lanes of a mask as the low eight bits of a number, lane 0 first; a mask of the lowest `count` lanes.
inline unsigned bits_of(const LaneMask& mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(std::bit_cast<__m256i>(mask))));
}
inline LaneMask first_lanes(int count) {
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    return std::bit_cast<LaneMask>(_mm256_cmpgt_epi32(_mm256_set1_epi32(count), lane));
}

/// A word below 2^31 as a number, and back towards zero.
inline FloatLanes number_of(WordLanes x) {
    return FloatLanes(_mm256_cvtepi32_ps(x.bits));
}
inline float number_of(std::uint32_t x) {
    return static_cast<float>(x);
}
inline WordLanes truncated(FloatLanes x) {
    return WordLanes(_mm256_cvttps_epi32(static_cast<__m256>(x)));
}
inline std::uint32_t truncated(float x) {
    return static_cast<std::uint32_t>(x);
}

inline WordLanes load_words(const std::uint32_t* from) {
    return WordLanes(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
}
inline void store(WordLanes x, std::uint32_t* to) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), x.bits);
}
inline WordLanes lane_numbers() {
    return WordLanes(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}

/// A number of 64 bits and the seven behind it, as their two words.
struct CountLanes {
    WordLanes low, high;
};
inline CountLanes counted_from(std::uint64_t first) {
    std::array<std::uint32_t, lane_count> low, high;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        low[lane] = static_cast<std::uint32_t>(first + lane);
        high[lane] = static_cast<std::uint32_t>((first + lane) >> 32);
    }
    return {load_words(low.data()), load_words(high.data())};
}

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool gather_by_instruction = false;
#elif defined(__has_feature)
inline constexpr bool gather_by_instruction = !__has_feature(address_sanitizer);
#else
inline constexpr bool gather_by_instruction = true;
#endif

/// table[index] in each lane; `stride` in words, 1 or 2. The address sanitizer does not see the instruction, so its builds loop.
template <int stride>
WordLanes gather(const std::uint32_t* table, WordLanes index) {
    if constexpr (gather_by_instruction) {
        return WordLanes(_mm256_i32gather_epi32(reinterpret_cast<const int*>(table), index.bits, 4 * stride));
    } else {
        std::array<std::uint32_t, lane_count> indices;
        store(index, indices.data());
        for (std::uint32_t& lane : indices) lane = table[static_cast<std::size_t>(lane) * stride];
        return load_words(indices.data());
    }
}

/// Two words that stand together, table[2 index] and the next, in each lane: one load a lane for both.
template <class Words>
struct WordPair {
    Words first, second;
};
inline WordPair<std::uint32_t> gather_pair(const std::uint32_t* table, std::uint32_t index) {
    return {table[2 * std::size_t{index}], table[2 * std::size_t{index} + 1]};
}
inline WordPair<WordLanes> gather_pair(const std::uint32_t* table, WordLanes index) {
    if constexpr (gather_by_instruction) {
        // Lanes 0, 1, 4, 5 and 2, 3, 6, 7, so that a shuffle within the halves puts them in order.
        const __m256i order = _mm256_permute4x64_epi64(index.bits, 0xd8);
        const auto* const pairs = reinterpret_cast<const long long*>(table);
        const __m256 a = _mm256_castsi256_ps(_mm256_i32gather_epi64(pairs, _mm256_castsi256_si128(order), 8));
        const __m256 b = _mm256_castsi256_ps(_mm256_i32gather_epi64(pairs, _mm256_extracti128_si256(order, 1), 8));
        return {WordLanes(_mm256_castps_si256(_mm256_shuffle_ps(a, b, 0x88))),
                WordLanes(_mm256_castps_si256(_mm256_shuffle_ps(a, b, 0xdd)))};
    } else {
        return {gather<2>(table, index), gather<2>(table + 1, index)};
    }
}

/// All 64 bits of a product, as its two words.
struct ProductLanes {
    WordLanes high, low;
};
inline ProductLanes wide_product(WordLanes a, std::uint32_t factor) {
    const __m256i f = _mm256_set1_epi32(static_cast<int>(factor));
    const __m256i even = _mm256_mul_epu32(a.bits, f), odd = _mm256_mul_epu32(_mm256_srli_epi64(a.bits, 32), f);
    return {WordLanes(_mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, 0xaa)),
            WordLanes(_mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xaa))};
}

/// Floor of a third of words below 2^31.
inline WordLanes third_of(WordLanes x) {
    return wide_product(x, 0x55555556u).high;
}
inline std::uint32_t third_of(std::uint32_t x) {
    return x / 3;
}

}  // namespace brewster
