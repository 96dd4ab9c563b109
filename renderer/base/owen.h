#pragma once
#include <array>
#include <cstdint>

#include "base/word_lanes.h"

namespace brewster {

inline std::uint32_t reverse_bytes(std::uint32_t x) {
    return __builtin_bswap32(x);
}
inline WordLanes reverse_bytes(WordLanes x) {
    return (x >> 24) | ((x >> 8) & WordLanes(0xff00u)) | ((x & WordLanes(0xff00u)) << 8) | (x << 24);
}

template <class Word>
Word reverse_bits(Word x) {
    x = ((x >> 1) & Word(0x55555555u)) | ((x & Word(0x55555555u)) << 1);
    x = ((x >> 2) & Word(0x33333333u)) | ((x & Word(0x33333333u)) << 2);
    x = ((x >> 4) & Word(0x0f0f0f0fu)) | ((x & Word(0x0f0f0f0fu)) << 4);
    return reverse_bytes(x);
}

/// A permutation of 32-bit words by `key` whose output bits each depend on the lower input bits only: on reversed words
/// that is a nested-uniform (Owen) scramble (Laine and Karras 2011, Burley 2020).
template <class Word>
Word permute_upwards(Word x, Word key) {
    x = x ^ (x * Word(0x3d20adeau));
    x = x + key;
    x = x * ((key >> 16) | Word(1u));
    x = x ^ (x * Word(0x05526c56u));
    return x ^ (x * Word(0x53a22864u));
}

/// A 32-bit hash (the finalizer of MurmurHash3) that makes keys of counters.
template <class Word>
Word mixed_bits(Word x) {
    x = (x ^ (x >> 16)) * Word(0x85ebca6bu);
    x = (x ^ (x >> 13)) * Word(0xc2b2ae35u);
    return x ^ (x >> 16);
}

/// Point `index` of the two-dimensional Sobol sequence, as 32-bit fixed point: indices shuffled and both coordinates
/// scrambled by `key`. The first 2^k points of each key are a (0,2)-net; those of different keys know nothing of each
/// other, so pairs make up points of any dimension (Burley 2020, "Practical hash-based Owen scrambling").
template <class Word>
std::array<Word, 2> sobol_pair(Word index, Word key) {
    const Word second_key = mixed_bits(key + Word(0x9e3779b9u)), third_key = mixed_bits(key + Word(0x3c6ef372u));
    const Word shuffled = reverse_bits(permute_upwards(reverse_bits(index), key));
    // Column i of the second dimension is (1 + z)^i over GF(2): n(z) becomes n(1 + z), and (1 + z)^k = 1 + z^k for
    // powers of two k.
    Word second = shuffled;
    second = second ^ ((second & Word(0xffff0000u)) >> 16);
    second = second ^ ((second & Word(0xff00ff00u)) >> 8);
    second = second ^ ((second & Word(0xf0f0f0f0u)) >> 4);
    second = second ^ ((second & Word(0xccccccccu)) >> 2);
    second = second ^ ((second & Word(0xaaaaaaaau)) >> 1);
    return {reverse_bits(permute_upwards(shuffled, second_key)), reverse_bits(permute_upwards(second, third_key))};
}

}  // namespace brewster
