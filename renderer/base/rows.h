#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/fixed_point.h"
#include "base/word_lanes.h"

/// Rows of eight floats in memory against lanes in registers: a row belongs to one lane. Moving eight rows of eight floats at a
/// time costs a third of gathering them column by column.
namespace brewster {

inline constexpr std::size_t row_size = 8;

/// Eight floats, or words in their place.
struct alignas(32) Row {
    std::array<float, row_size> x{};
};

/// Eight columns of lanes: lane i of column j is float j of the row that starts at `row(i)`.
using Columns = std::array<FloatLanes, row_size>;

template <class RowOfLane>
[[gnu::always_inline]] inline Columns load_columns(const RowOfLane& row) {
    __m256 r[lane_groups][8];
    for (int lane = 0; lane < lane_count; ++lane) r[lane / 8][lane % 8] = _mm256_loadu_ps(row(lane));
    return lanes_detail::columns_of(r);
}

/// Row `index` of a table, for one lane and for all.
inline std::array<float, row_size> row_at(const std::vector<Row>& rows, std::uint32_t index) {
    return rows[index].x;
}
inline Columns row_at(const std::vector<Row>& rows, WordLanes index) {
    std::array<std::uint32_t, lane_count> indices;
    store(index, indices.data());
    return load_columns([&](int lane) { return rows[indices[static_cast<std::size_t>(lane)]].x.data(); });
}

/// load_columns backwards; rows are written in the order of their lanes, so that a later one may overwrite an earlier.
template <class RowOfLane>
[[gnu::always_inline]] inline void store_columns(const Columns& columns, const RowOfLane& row) {
    const auto store_eight = [&]<int group>() {
        __m256 r[8];
        for (std::size_t j = 0; j < row_size; ++j) r[j] = registers::eight_of<group>(register_of(columns[j]));
        lanes_detail::transpose(r);
        for (int lane = 0; lane < 8; ++lane) _mm256_storeu_ps(row(8 * group + lane), r[lane]);
    };
    store_eight.template operator()<0>();
    if constexpr (lane_groups > 1) store_eight.template operator()<lane_groups - 1>();
}

/// to_quanta of four weights.
inline __m256i quanta_of(__m128 weights) {
    const __m256d magic = _mm256_set1_pd(rounding_magic);
    const __m256d sum = _mm256_fmadd_pd(_mm256_cvtps_pd(weights), _mm256_set1_pd(quanta_per_weight), magic);
    return _mm256_sub_epi64(_mm256_castpd_si256(sum), _mm256_castpd_si256(magic));
}

/// The sum over the lanes of `mask` of to_quanta(weight), four partial sums.
struct QuantaLanes {
    __m256i sums = _mm256_setzero_si256();

    void add(const LaneMask& mask, FloatLanes weights) { accumulate<true>(mask, weights); }
    void subtract(const LaneMask& mask, FloatLanes weights) { accumulate<false>(mask, weights); }
    Quanta total() const {
        alignas(32) Quanta part[4];
        _mm256_store_si256(reinterpret_cast<__m256i*>(part), sums);
        return part[0] + part[1] + part[2] + part[3];
    }

  private:
    template <bool add>
    void accumulate(const LaneMask& mask, FloatLanes weights) {
        const registers::Floats kept = register_of(select(mask, weights, FloatLanes(0.0f)));
        accumulate_eight<add>(registers::eight_of<0>(kept));
        if constexpr (lane_groups > 1) accumulate_eight<add>(registers::eight_of<lane_groups - 1>(kept));
    }
    template <bool add>
    void accumulate_eight(__m256 kept) {
        const __m256i both =
            _mm256_add_epi64(quanta_of(_mm256_castps256_ps128(kept)), quanta_of(_mm256_extractf128_ps(kept, 1)));
        sums = add ? _mm256_add_epi64(sums, both) : _mm256_sub_epi64(sums, both);
    }
};

/// Asks for the memory of `bytes` behind an address.
inline void prefetch(const void* from, std::size_t bytes) {
    const char* const at = static_cast<const char*>(from);
    for (std::size_t i = 0; i < bytes; i += 64) _mm_prefetch(at + i, _MM_HINT_T0);
}

}  // namespace brewster
