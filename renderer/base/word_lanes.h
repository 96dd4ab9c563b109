#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "base/lanes.h"

/// The integer half of the SIMD seam: 32-bit words in lanes, beside the floats of lanes.h.
namespace brewster {

struct WordLanes {
    registers::Words bits{};

    WordLanes() = default;
    explicit WordLanes(registers::Words from) : bits(from) {}
    explicit WordLanes(std::uint32_t everywhere) : bits(registers::everywhere(everywhere)) {}

    friend WordLanes operator+(WordLanes a, WordLanes b) { return WordLanes(registers::add(a.bits, b.bits)); }
    friend WordLanes operator-(WordLanes a, WordLanes b) { return WordLanes(registers::subtract(a.bits, b.bits)); }
    friend WordLanes operator*(WordLanes a, WordLanes b) { return WordLanes(registers::multiply(a.bits, b.bits)); }
    friend WordLanes operator&(WordLanes a, WordLanes b) { return WordLanes(registers::both(a.bits, b.bits)); }
    friend WordLanes operator|(WordLanes a, WordLanes b) { return WordLanes(registers::either(a.bits, b.bits)); }
    friend WordLanes operator^(WordLanes a, WordLanes b) { return WordLanes(registers::one_of(a.bits, b.bits)); }
    friend WordLanes operator<<(WordLanes a, int by) { return WordLanes(registers::shifted_left(a.bits, by)); }
    friend WordLanes operator>>(WordLanes a, int by) { return WordLanes(registers::shifted_right(a.bits, by)); }
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
    return WordLanes(registers::as_words(register_of(x)));
}
inline std::uint32_t words_of(float x) {
    return std::bit_cast<std::uint32_t>(x);
}
inline FloatLanes floats_of(WordLanes x) {
    return FloatLanes(registers::as_floats(x.bits));
}
inline float floats_of(std::uint32_t x) {
    return std::bit_cast<float>(x);
}

inline LaneMask equal(WordLanes a, WordLanes b) {
    return registers::equal(a.bits, b.bits);
}
inline bool equal(std::uint32_t a, std::uint32_t b) {
    return a == b;
}
/// a < b of words below 2^31.
inline LaneMask below(WordLanes a, WordLanes b) {
    return registers::above(b.bits, a.bits);
}
inline bool below(std::uint32_t a, std::uint32_t b) {
    return a < b;
}
inline LaneMask has_top_bit(WordLanes x) {
    return registers::has_top_bit(x.bits);
}
inline bool has_top_bit(std::uint32_t x) {
    return x >> 31 != 0;
}
inline WordLanes select(const LaneMask& mask, WordLanes a, WordLanes b) {
    return WordLanes(registers::select(mask, a.bits, b.bits));
}
inline std::uint32_t select(bool mask, std::uint32_t a, std::uint32_t b) {
    return mask ? a : b;
}

/// The lanes of a mask as the low bits of a number, lane 0 first; a mask of the lowest `count` lanes.
inline unsigned bits_of(const LaneMask& mask) {
    return registers::bits_of(mask);
}
inline LaneMask first_lanes(int count) {
    return registers::first_lanes(count);
}

/// A word below 2^31 as a number, and back towards zero.
inline FloatLanes number_of(WordLanes x) {
    return FloatLanes(registers::number_of(x.bits));
}
inline float number_of(std::uint32_t x) {
    return static_cast<float>(x);
}
inline WordLanes truncated(FloatLanes x) {
    return WordLanes(registers::truncated(register_of(x)));
}
inline std::uint32_t truncated(float x) {
    return static_cast<std::uint32_t>(x);
}

inline WordLanes load_words(const std::uint32_t* from) {
    return WordLanes(registers::load(from));
}
inline void store(WordLanes x, std::uint32_t* to) {
    registers::store(x.bits, to);
}
inline WordLanes lane_numbers() {
    return WordLanes(registers::lane_numbers());
}

/// A number of 64 bits and those behind it, one a lane, as their two words.
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
        return WordLanes(registers::gather<stride>(table, index.bits));
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
        const auto [first, second] = registers::gather_pair(table, index.bits);
        return {WordLanes(first), WordLanes(second)};
    } else {
        return {gather<2>(table, index), gather<2>(table + 1, index)};
    }
}

/// All 64 bits of a product, as its two words.
struct ProductLanes {
    WordLanes high, low;
};
inline ProductLanes wide_product(WordLanes a, std::uint32_t factor) {
    const auto [high, low] = registers::wide_product(a.bits, factor);
    return {WordLanes(high), WordLanes(low)};
}

/// Floor of a third of words below 2^31.
inline WordLanes third_of(WordLanes x) {
    return wide_product(x, 0x55555556u).high;
}
inline std::uint32_t third_of(std::uint32_t x) {
    return x / 3;
}

}  // namespace brewster
