#pragma once
#include <array>
#include <bit>

#include "base/rows.h"
#include "bins/imprint.h"

namespace brewster::transport {

/// Files arrivals some batches later than they come, so that the records are on their way from memory meanwhile.
template <int D, int most_fields, int bands, std::size_t most_batches>
class PendingImprints {
  public:
    using Places = std::array<ImprintPlace, lane_count>;
    static constexpr std::size_t most_weights = static_cast<std::size_t>(most_fields * bands);

    /// One arrival a lane of `mask`, at the leaf of that lane. `weights`: per field and band; `at`: cell coordinates.
    void add(Tally<D>& tally, const LaneMask& mask, WordLanes leaf, const Places& places, const FloatLanes* weights,
             const std::array<FloatLanes, D>& at) {
        if (count_ == most_batches) flush(tally);
        Pending& batch = batches_[count_++];
        batch.mask = bits_of(mask);
        store(leaf, batch.leaves.data());
        batch.places = places;
        for (unsigned left = batch.mask; left != 0; left &= left - 1) {
            const std::uint32_t row = batch.leaves[static_cast<std::size_t>(std::countr_zero(left))];
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
            store_columns(columns,
                          [&](int lane) { return batch.numbers[static_cast<std::size_t>(lane)][row].x.data(); });
        }
    }

    void flush(Tally<D>& tally) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Pending& batch = batches_[i];
            for (unsigned left = batch.mask; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const float* const numbers = batch.numbers[lane][0].x.data();
                const auto rows_of_leaf = tally.touch(batch.leaves[lane]);
                add_imprint<D>(numbers + D, numbers, batch.places[lane], bands, rows_of_leaf.estimate,
                               rows_of_leaf.test);
            }
        }
        count_ = 0;
    }

  private:
    static constexpr std::size_t rows = (D + most_weights + row_size - 1) / row_size;

    struct Pending {
        unsigned mask = 0;
        std::array<std::uint32_t, lane_count> leaves{};
        Places places{};
        std::array<std::array<Row, rows>, lane_count> numbers{};
    };

    std::size_t count_ = 0;
    std::array<Pending, most_batches> batches_;
};

}  // namespace brewster::transport
