#pragma once
#include <array>
#include <bit>

#include "base/rows.h"
#include "bins/imprint.h"

namespace brewster::transport {

/// Files arrivals a batch later than they come, so that the records are on their way from memory meanwhile.
template <int D, int most_fields, int bands>
class PendingImprints {
  public:
    using Places = std::array<ImprintPlace, lane_count>;
    static constexpr std::size_t most_weights = static_cast<std::size_t>(most_fields * bands);

    /// One arrival a lane of `mask`, at the leaf of that lane. `weights`: per field and band; `at`: cell coordinates.
    void add(Tally<D>& tally, const LaneMask& mask, WordLanes leaf, const Places& places, const FloatLanes* weights,
             const std::array<FloatLanes, D>& at) {
        flush(tally);
        mask_ = bits_of(mask);
        store(leaf, leaves_.data());
        places_ = places;
        for (unsigned left = mask_; left != 0; left &= left - 1) {
            const std::uint32_t row = leaves_[static_cast<std::size_t>(std::countr_zero(left))];
            prefetch(tally.estimate(row), tally.estimate_size() * sizeof(Quanta));
            prefetch(tally.test(row), tally.test_size() * sizeof(Quanta));
        }
        // The coordinates come first.
        std::array<FloatLanes, rows * row_size> numbers{};
        for (std::size_t a = 0; a < D; ++a) numbers[a] = at[a];
        for (std::size_t i = 0; i < most_weights; ++i) numbers[D + i] = weights[i];
        for (std::size_t row = 0; row < rows; ++row) {
            Columns columns;
            for (std::size_t j = 0; j < row_size; ++j) columns[j] = numbers[row * row_size + j];
            store_columns(columns, [&](int lane) { return rows_[static_cast<std::size_t>(lane)][row].x.data(); });
        }
    }

    void flush(Tally<D>& tally) {
        for (; mask_ != 0; mask_ &= mask_ - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(mask_));
            const float* const numbers = rows_[lane][0].x.data();
            add_imprint<D>(numbers + D, numbers, places_[lane], bands, tally.estimate(leaves_[lane]),
                           tally.test(leaves_[lane]));
        }
    }

  private:
    static constexpr std::size_t rows = (D + most_weights + row_size - 1) / row_size;

    unsigned mask_ = 0;
    std::array<std::uint32_t, lane_count> leaves_{};
    Places places_{};
    std::array<std::array<Row, rows>, lane_count> rows_{};
};

}  // namespace brewster::transport
