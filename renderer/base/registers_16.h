#pragma once
#include <immintrin.h>

#include <cstdint>
#include <experimental/simd>

/// What lanes are made of, sixteen in a register: AVX-512 (x86-64-v4). The same functions as in registers_8.h, each with
/// the same bits.
namespace brewster::registers {

using FloatBatch = std::experimental::simd<float, std::experimental::simd_abi::_VecBltnBtmsk<64>>;
using Mask = FloatBatch::mask_type;
using Floats = __m512;
using Words = __m512i;

inline Floats fma(Floats a, Floats b, Floats c) {
    return _mm512_fmadd_ps(a, b, c);
}
inline Floats sqrt(Floats x) {
    return _mm512_sqrt_ps(x);
}
inline Floats abs(Floats x) {
    return _mm512_andnot_ps(_mm512_set1_ps(-0.0f), x);
}
inline Floats floor(Floats x) {
    return _mm512_roundscale_ps(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
inline Floats round_even(Floats x) {
    return _mm512_roundscale_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
inline Floats min(Floats a, Floats b) {
    return _mm512_min_ps(a, b);
}
inline Floats max(Floats a, Floats b) {
    return _mm512_max_ps(a, b);
}

inline Floats load(const float* from) {
    return _mm512_loadu_ps(from);
}
inline void store(Floats x, float* to) {
    _mm512_storeu_ps(to, x);
}
inline Words load(const std::uint32_t* from) {
    return _mm512_loadu_si512(from);
}
inline void store(Words x, std::uint32_t* to) {
    _mm512_storeu_si512(to, x);
}

inline Words everywhere(std::uint32_t x) {
    return _mm512_set1_epi32(static_cast<int>(x));
}
inline Words lane_numbers() {
    return _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
inline Words add(Words a, Words b) {
    return _mm512_add_epi32(a, b);
}
inline Words subtract(Words a, Words b) {
    return _mm512_sub_epi32(a, b);
}
inline Words multiply(Words a, Words b) {
    return _mm512_mullo_epi32(a, b);
}
inline Words both(Words a, Words b) {
    return _mm512_and_si512(a, b);
}
inline Words either(Words a, Words b) {
    return _mm512_or_si512(a, b);
}
inline Words one_of(Words a, Words b) {
    return _mm512_xor_si512(a, b);
}
inline Words shifted_left(Words a, int by) {
    return _mm512_slli_epi32(a, static_cast<unsigned>(by));
}
inline Words shifted_right(Words a, int by) {
    return _mm512_srli_epi32(a, static_cast<unsigned>(by));
}
inline Words shifted_right_signed(Words a, int by) {
    return _mm512_srai_epi32(a, static_cast<unsigned>(by));
}
struct TwoWords {
    Words first, second;
};
/// The upper and the lower words of 64-bit products.
inline TwoWords wide_product(Words a, std::uint32_t factor) {
    const Words f = everywhere(factor);
    const Words even = _mm512_mul_epu32(a, f), odd = _mm512_mul_epu32(_mm512_srli_epi64(a, 32), f);
    return {_mm512_mask_blend_epi32(0xaaaa, _mm512_srli_epi64(even, 32), odd),
            _mm512_mask_blend_epi32(0xaaaa, even, _mm512_slli_epi64(odd, 32))};
}

/// The same bits.
inline Words as_words(Floats x) {
    return _mm512_castps_si512(x);
}
inline Floats as_floats(Words x) {
    return _mm512_castsi512_ps(x);
}
/// The same numbers, as signed integers; `rounded` to the nearest, `truncated` towards zero.
inline Floats number_of(Words x) {
    return _mm512_cvtepi32_ps(x);
}
inline Words rounded(Floats x) {
    return _mm512_cvtps_epi32(x);
}
inline Words truncated(Floats x) {
    return _mm512_cvttps_epi32(x);
}

inline Mask mask_of(__mmask16 bits) {
    return Mask(std::experimental::__private_init, static_cast<std::uint16_t>(bits));
}
inline unsigned bits_of(const Mask& mask) {
    return static_cast<std::uint16_t>(std::experimental::__data(mask)._M_data);
}
inline Mask equal(Words a, Words b) {
    return mask_of(_mm512_cmpeq_epi32_mask(a, b));
}
inline Mask above(Words a, Words b) {  // signed
    return mask_of(_mm512_cmpgt_epi32_mask(a, b));
}
inline Mask has_top_bit(Words x) {
    return mask_of(_mm512_movepi32_mask(x));
}
inline Words select(const Mask& mask, Words a, Words b) {
    return _mm512_mask_blend_epi32(static_cast<__mmask16>(bits_of(mask)), b, a);
}
inline Mask first_lanes(int count) {
    return mask_of(static_cast<__mmask16>((1u << count) - 1));
}

/// table[index], `stride` in words.
template <int stride>
Words gather(const std::uint32_t* table, Words index) {
    return _mm512_i32gather_epi32(index, reinterpret_cast<const int*>(table), 4 * stride);
}
/// table[2 index] and table[2 index + 1].
inline TwoWords gather_pair(const std::uint32_t* table, Words index) {
    const auto* const pairs = reinterpret_cast<const long long*>(table);
    const __m512i a = _mm512_i32gather_epi64(_mm512_castsi512_si256(index), pairs, 8);
    const __m512i b = _mm512_i32gather_epi64(_mm512_extracti64x4_epi64(index, 1), pairs, 8);
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    const __m512i odd = _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
    return {_mm512_permutex2var_epi32(a, even, b), _mm512_permutex2var_epi32(a, odd, b)};
}

/// A register as groups of eight lanes, and back.
inline constexpr int groups = 2;
template <int group>
__m256 eight_of(Floats x) {
    return _mm512_extractf32x8_ps(x, group);
}
inline Floats joined(const __m256 (&eights)[groups]) {
    return _mm512_insertf32x8(_mm512_castps256_ps512(eights[0]), eights[1], 1);
}

}  // namespace brewster::registers
