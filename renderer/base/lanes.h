#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if BREWSTER_WIDE
#include "base/registers_16.h"
#else
#include "base/registers_8.h"
#endif

/// The SIMD seam. A formula is written once as `template <class Real>` and used with Real = float, double and
/// FloatLanes; the functions below are all it may use beside + - * /, comparisons, && || ! on masks and small integer
/// constants. Each gives the same bits for a float as for a lane: IEEE operations only, fma where it is written,
/// no branch on a value (`select` instead).
namespace brewster {

/// Eight lanes, or sixteen where BREWSTER_WIDE is set: nothing that outlives a call may depend on it.
using FloatLanes = registers::FloatBatch;
using LaneMask = FloatLanes::mask_type;
inline constexpr int lane_count = static_cast<int>(FloatLanes::size());
inline constexpr int lane_groups = registers::groups;  ///< of eight, which is as many as there are floats in a row

inline registers::Floats register_of(FloatLanes x) {
    return static_cast<registers::Floats>(x);
}

/// The type of one lane.
template <class Real>
struct ScalarOf {
    using type = Real;
};
template <>
struct ScalarOf<FloatLanes> {
    using type = float;
};
template <class Real>
using Scalar = typename ScalarOf<Real>::type;

/// A constant in every lane, rounded once to the type of a lane.
template <class Real>
constexpr Real constant(double value) {
    return Real(static_cast<Scalar<Real>>(value));
}

inline float fma(float a, float b, float c) {
    return std::fma(a, b, c);
}
inline double fma(double a, double b, double c) {
    return std::fma(a, b, c);
}
// The library's own fma is called out of line at -O2, hence the intrinsic.
inline FloatLanes fma(FloatLanes a, FloatLanes b, FloatLanes c) {
    return FloatLanes(registers::fma(register_of(a), register_of(b), register_of(c)));
}

inline float sqrt(float x) {
    return std::sqrt(x);
}
inline double sqrt(double x) {
    return std::sqrt(x);
}
inline FloatLanes sqrt(FloatLanes x) {
    return FloatLanes(registers::sqrt(register_of(x)));
}

inline float abs(float x) {
    return std::fabs(x);
}
inline double abs(double x) {
    return std::fabs(x);
}
inline FloatLanes abs(FloatLanes x) {
    return FloatLanes(registers::abs(register_of(x)));
}

inline float floor(float x) {
    return std::floor(x);
}
inline double floor(double x) {
    return std::floor(x);
}
inline FloatLanes floor(FloatLanes x) {
    return FloatLanes(registers::floor(register_of(x)));
}

/// To the nearest integer, ties to even.
inline float round_even(float x) {
    return std::rint(x);
}
inline double round_even(double x) {
    return std::rint(x);
}
inline FloatLanes round_even(FloatLanes x) {
    return FloatLanes(registers::round_even(register_of(x)));
}

/// min and max return their second argument if either is NaN or both are zeros.
inline float min(float a, float b) {
    return a < b ? a : b;
}
inline double min(double a, double b) {
    return a < b ? a : b;
}
inline FloatLanes min(FloatLanes a, FloatLanes b) {
    return FloatLanes(registers::min(register_of(a), register_of(b)));
}
inline float max(float a, float b) {
    return a > b ? a : b;
}
inline double max(double a, double b) {
    return a > b ? a : b;
}
inline FloatLanes max(FloatLanes a, FloatLanes b) {
    return FloatLanes(registers::max(register_of(a), register_of(b)));
}

/// Lane by lane `mask ? a : b`; both are evaluated.
inline float select(bool mask, float a, float b) {
    return mask ? a : b;
}
inline double select(bool mask, double a, double b) {
    return mask ? a : b;
}
inline FloatLanes select(const LaneMask& mask, FloatLanes a, FloatLanes b) {
    std::experimental::where(mask, b) = a;
    return b;
}

inline bool any_of(bool mask) {
    return mask;
}
inline bool any_of(const LaneMask& mask) {
    return std::experimental::any_of(mask);
}

/// 2^k for an integral k in [-126, 127].
inline float power_of_two(float k) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(static_cast<std::int32_t>(k) + 127) << 23);
}
inline FloatLanes power_of_two(FloatLanes k) {
    const registers::Words exponent = registers::add(registers::rounded(register_of(k)), registers::everywhere(127));
    return FloatLanes(registers::as_floats(registers::shifted_left(exponent, 23)));
}

/// x = mantissa * 2^exponent with the mantissa in [sqrt(1/2), sqrt(2)); x must be positive and normal.
template <class Real>
struct MantissaExponent {
    Real mantissa, exponent;
};
inline constexpr std::uint32_t bits_of_sqrt_half = 0x3f3504f3u;
inline MantissaExponent<float> split_exponent(float x) {
    const std::uint32_t offset = std::bit_cast<std::uint32_t>(x) - bits_of_sqrt_half;
    const std::int32_t exponent = static_cast<std::int32_t>(offset) >> 23;
    return {std::bit_cast<float>((offset & 0x007fffffu) + bits_of_sqrt_half), static_cast<float>(exponent)};
}
inline MantissaExponent<FloatLanes> split_exponent(FloatLanes x) {
    const registers::Words base = registers::everywhere(bits_of_sqrt_half);
    const registers::Words offset = registers::subtract(registers::as_words(register_of(x)), base);
    const registers::Words mantissa = registers::add(registers::both(offset, registers::everywhere(0x007fffff)), base);
    return {FloatLanes(registers::as_floats(mantissa)),
            FloatLanes(registers::number_of(registers::shifted_right_signed(offset, 23)))};
}

/// Floats in memory, any alignment, as a batch; one for a scalar.
template <class Real>
Real load(const Scalar<Real>* from) {
    if constexpr (std::is_same_v<Real, FloatLanes>)
        return FloatLanes(registers::load(from));
    else
        return *from;
}
inline void store(float x, float* to) {
    *to = x;
}
inline void store(double x, double* to) {
    *to = x;
}
inline void store(FloatLanes x, float* to) {
    registers::store(register_of(x), to);
}

namespace lanes_detail {

/// Eight rows of eight floats become eight columns.
[[gnu::always_inline]] inline void transpose(__m256 (&r)[8]) {
    __m256 pairs[8], quads[8];
    for (int j = 0; j < 4; ++j) {
        pairs[2 * j] = _mm256_unpacklo_ps(r[2 * j], r[2 * j + 1]);
        pairs[2 * j + 1] = _mm256_unpackhi_ps(r[2 * j], r[2 * j + 1]);
    }
    for (int k = 0; k < 8; k += 4) {
        quads[k] = _mm256_shuffle_ps(pairs[k], pairs[k + 2], 0x44);
        quads[k + 1] = _mm256_shuffle_ps(pairs[k], pairs[k + 2], 0xee);
        quads[k + 2] = _mm256_shuffle_ps(pairs[k + 1], pairs[k + 3], 0x44);
        quads[k + 3] = _mm256_shuffle_ps(pairs[k + 1], pairs[k + 3], 0xee);
    }
    for (int j = 0; j < 4; ++j) {
        r[j] = _mm256_permute2f128_ps(quads[j], quads[j + 4], 0x20);
        r[j + 4] = _mm256_permute2f128_ps(quads[j], quads[j + 4], 0x31);
    }
}

/// Rows of eight floats, one a lane, as eight columns of lanes.
[[gnu::always_inline]] inline std::array<FloatLanes, 8> columns_of(__m256 (&rows)[lane_groups][8]) {
    for (auto& group : rows) transpose(group);
    std::array<FloatLanes, 8> columns;
    for (std::size_t j = 0; j < 8; ++j) {
        __m256 eights[lane_groups];
        for (std::size_t group = 0; group < lane_groups; ++group) eights[group] = rows[group][j];
        columns[j] = FloatLanes(registers::joined(eights));
    }
    return columns;
}

}  // namespace lanes_detail

/// Row `index` of a table, one row a lane; index is integral and inside the table.
template <class Real, std::size_t columns>
std::array<Real, columns> read_row(const std::array<float, columns>* table, const Real& index) {
    std::array<Real, columns> row;
    if constexpr (std::is_same_v<Real, FloatLanes>) {
        std::array<float, lane_count> indices;
        store(index, indices.data());
        std::array<std::array<float, lane_count>, columns> transposed;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const std::array<float, columns>& from = table[static_cast<std::size_t>(indices[lane])];
            for (std::size_t column = 0; column < columns; ++column) transposed[column][lane] = from[column];
        }
        for (std::size_t column = 0; column < columns; ++column) row[column] = load<Real>(transposed[column].data());
    } else {
        const std::array<float, columns>& from = table[static_cast<std::size_t>(index)];
        for (std::size_t column = 0; column < columns; ++column) row[column] = from[column];
    }
    return row;
}

/// Rows `index` and `index` + 1 blended, low + fraction (high - low), one pair a lane: eight columns are read, blended
/// and transposed at a time, which is three times as fast as column by column.
template <class Real, std::size_t columns>
std::array<Real, columns> blend_rows(const std::array<float, columns>* table, const Real& index, const Real& fraction) {
    std::array<Real, columns> row;
    if constexpr (std::is_same_v<Real, FloatLanes>) {
        static_assert(columns % 8 == 0);
        std::array<float, lane_count> indices, fractions;
        store(index, indices.data());
        store(fraction, fractions.data());
        for (std::size_t block = 0; block < columns; block += 8) {
            __m256 r[lane_groups][8];
            for (std::size_t lane = 0; lane < lane_count; ++lane) {
                const std::array<float, columns>* from = table + static_cast<std::size_t>(indices[lane]);
                const __m256 low = _mm256_loadu_ps(from[0].data() + block),
                             high = _mm256_loadu_ps(from[1].data() + block);
                r[lane / 8][lane % 8] = _mm256_fmadd_ps(_mm256_set1_ps(fractions[lane]), _mm256_sub_ps(high, low), low);
            }
            const std::array<FloatLanes, 8> blended = lanes_detail::columns_of(r);
            std::copy(blended.begin(), blended.end(), row.begin() + static_cast<std::ptrdiff_t>(block));
        }
    } else {
        const std::array<float, columns>* from = table + static_cast<std::size_t>(index);
        for (std::size_t column = 0; column < columns; ++column) {
            const Real low = from[0][column], high = from[1][column];
            row[column] = fma(fraction, high - low, low);
        }
    }
    return row;
}

}  // namespace brewster
