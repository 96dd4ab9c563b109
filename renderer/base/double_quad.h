#pragma once
#include <immintrin.h>

#include "base/fixed_point.h"

/// The part of the SIMD seam that tallies: four doubles beside four integers.
namespace brewster {

struct DoubleQuad {
    __m256d x;

    friend DoubleQuad operator-(DoubleQuad a, DoubleQuad b) { return {_mm256_sub_pd(a.x, b.x)}; }
    friend DoubleQuad operator*(DoubleQuad a, DoubleQuad b) { return {_mm256_mul_pd(a.x, b.x)}; }
};

inline DoubleQuad everywhere(double x) {
    return {_mm256_set1_pd(x)};
}
inline DoubleQuad load_quad(const float* four) {
    return {_mm256_cvtps_pd(_mm_loadu_ps(four))};
}

/// Numbers a, b, c, d of a quad in this order.
template <int a, int b, int c, int d>
DoubleQuad ordered(DoubleQuad q) {
    return {_mm256_permute4x64_pd(q.x, a | b << 2 | c << 4 | d << 6)};
}
/// The first `count` numbers of one quad, the rest of another.
template <int count>
DoubleQuad joined(DoubleQuad first, DoubleQuad rest) {
    return {_mm256_blend_pd(rest.x, first.x, (1 << count) - 1)};
}

/// -1 below zero, else 1.
inline DoubleQuad sign_of(DoubleQuad q) {
    const __m256d below = _mm256_cmp_pd(q.x, _mm256_setzero_pd(), _CMP_LT_OQ);
    return {_mm256_or_pd(_mm256_and_pd(below, _mm256_set1_pd(-0.0)), _mm256_set1_pd(1.0))};
}

/// A weight in quanta everywhere, not yet rounded: a power of two times it.
inline DoubleQuad in_quanta(float weight) {
    return everywhere(static_cast<double>(weight) * quanta_per_weight);
}

/// sums[i] += weight times factor, rounded once to quanta, ties to even.
inline void add_quanta(Quanta* sums, DoubleQuad weight_in_quanta, DoubleQuad factor) {
    const __m256d magic = _mm256_set1_pd(rounding_magic);
    const __m256d rounded = _mm256_fmadd_pd(weight_in_quanta.x, factor.x, magic);
    const __m256i quanta = _mm256_sub_epi64(_mm256_castpd_si256(rounded), _mm256_castpd_si256(magic));
    auto* const at = reinterpret_cast<__m256i*>(sums);
    _mm256_storeu_si256(at, _mm256_add_epi64(_mm256_loadu_si256(at), quanta));
}
/// The same of the first two numbers.
inline void add_two_quanta(Quanta* sums, DoubleQuad weight_in_quanta, DoubleQuad factor) {
    const __m128d magic = _mm_set1_pd(rounding_magic);
    const __m128d rounded =
        _mm_fmadd_pd(_mm256_castpd256_pd128(weight_in_quanta.x), _mm256_castpd256_pd128(factor.x), magic);
    const __m128i quanta = _mm_sub_epi64(_mm_castpd_si128(rounded), _mm_castpd_si128(magic));
    auto* const at = reinterpret_cast<__m128i*>(sums);
    _mm_storeu_si128(at, _mm_add_epi64(_mm_loadu_si128(at), quanta));
}

}  // namespace brewster
