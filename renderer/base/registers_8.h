#pragma once
#include <immintrin.h>

#include <bit>
#include <cstdint>
#include <experimental/simd>

/// What lanes are made of, eight in a register: AVX2 (x86-64-v3). The same functions as in registers_16.h.
namespace brewster::registers {

using FloatBatch = std::experimental::simd<float, std::experimental::simd_abi::_VecBuiltin<32>>;
using Mask = FloatBatch::mask_type;
using Floats = __m256;
using Words = __m256i;

inline Floats fma(Floats a, Floats b, Floats c) {
    return _mm256_fmadd_ps(a, b, c);
}
inline Floats sqrt(Floats x) {
    return _mm256_sqrt_ps(x);
}
inline Floats abs(Floats x) {
    return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), x);
}
inline Floats floor(Floats x) {
    return _mm256_floor_ps(x);
}
inline Floats round_even(Floats x) {
    return _mm256_round_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
inline Floats min(Floats a, Floats b) {
    return _mm256_min_ps(a, b);
}
inline Floats max(Floats a, Floats b) {
    return _mm256_max_ps(a, b);
}

inline Floats load(const float* from) {
    return _mm256_loadu_ps(from);
}
inline void store(Floats x, float* to) {
    _mm256_storeu_ps(to, x);
}
inline Words load(const std::uint32_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
inline void store(Words x, std::uint32_t* to) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), x);
}

inline Words everywhere(std::uint32_t x) {
    return _mm256_set1_epi32(static_cast<int>(x));
}
inline Words lane_numbers() {
    return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
}
inline Words add(Words a, Words b) {
    return _mm256_add_epi32(a, b);
}
inline Words subtract(Words a, Words b) {
    return _mm256_sub_epi32(a, b);
}
inline Words multiply(Words a, Words b) {
    return _mm256_mullo_epi32(a, b);
}
inline Words both(Words a, Words b) {
    return _mm256_and_si256(a, b);
}
inline Words either(Words a, Words b) {
    return _mm256_or_si256(a, b);
}
inline Words one_of(Words a, Words b) {
    return _mm256_xor_si256(a, b);
}
inline Words shifted_left(Words a, int by) {
    return _mm256_slli_epi32(a, by);
}
inline Words shifted_right(Words a, int by) {
    return _mm256_srli_epi32(a, by);
}
inline Words shifted_right_signed(Words a, int by) {
    return _mm256_srai_epi32(a, by);
}
struct TwoWords {
    Words first, second;
};
/// The upper and the lower words of 64-bit products.
inline TwoWords wide_product(Words a, std::uint32_t factor) {
    const Words f = everywhere(factor);
    const Words even = _mm256_mul_epu32(a, f), odd = _mm256_mul_epu32(_mm256_srli_epi64(a, 32), f);
    return {_mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, 0xaa),
            _mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xaa)};
}

/// The same bits.
inline Words as_words(Floats x) {
    return _mm256_castps_si256(x);
}
inline Floats as_floats(Words x) {
    return _mm256_castsi256_ps(x);
}
/// The same numbers, as signed integers; `rounded` to the nearest, `truncated` towards zero.
inline Floats number_of(Words x) {
    return _mm256_cvtepi32_ps(x);
}
inline Words rounded(Floats x) {
    return _mm256_cvtps_epi32(x);
}
inline Words truncated(Floats x) {
    return _mm256_cvttps_epi32(x);
}

inline Mask equal(Words a, Words b) {
    return std::bit_cast<Mask>(_mm256_cmpeq_epi32(a, b));
}
inline Mask above(Words a, Words b) {  // signed
    return std::bit_cast<Mask>(_mm256_cmpgt_epi32(a, b));
}
inline Mask has_top_bit(Words x) {
    return std::bit_cast<Mask>(_mm256_srai_epi32(x, 31));
}
inline Words select(const Mask& mask, Words a, Words b) {
    return _mm256_blendv_epi8(b, a, std::bit_cast<__m256i>(mask));
}
inline unsigned bits_of(const Mask& mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(std::bit_cast<__m256i>(mask))));
}
inline Mask first_lanes(int count) {
    return above(_mm256_set1_epi32(count), lane_numbers());
}

/// table[index], `stride` in words.
template <int stride>
Words gather(const std::uint32_t* table, Words index) {
    return _mm256_i32gather_epi32(reinterpret_cast<const int*>(table), index, 4 * stride);
}
/// table[2 index] and table[2 index + 1].
inline TwoWords gather_pair(const std::uint32_t* table, Words index) {
    // Lanes 0, 1, 4, 5 and 2, 3, 6, 7, so that a shuffle within the halves puts them in order.
    const __m256i order = _mm256_permute4x64_epi64(index, 0xd8);
    const auto* const pairs = reinterpret_cast<const long long*>(table);
    const __m256 a = _mm256_castsi256_ps(_mm256_i32gather_epi64(pairs, _mm256_castsi256_si128(order), 8));
    const __m256 b = _mm256_castsi256_ps(_mm256_i32gather_epi64(pairs, _mm256_extracti128_si256(order, 1), 8));
    return {_mm256_castps_si256(_mm256_shuffle_ps(a, b, 0x88)), _mm256_castps_si256(_mm256_shuffle_ps(a, b, 0xdd))};
}

/// A register as groups of eight lanes, and back.
inline constexpr int groups = 1;
template <int group>
__m256 eight_of(Floats x) {
    static_assert(group == 0);
    return x;
}
inline Floats joined(const __m256 (&eights)[groups]) {
    return eights[0];
}

}  // namespace brewster::registers
