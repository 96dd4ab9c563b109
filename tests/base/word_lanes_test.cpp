#include "base/word_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "base/rows.h"
#include "base/sobol.h"

namespace brewster {
namespace {

std::array<std::uint32_t, lane_count> lanes_of(WordLanes x) {
    std::array<std::uint32_t, lane_count> lanes;
    store(x, lanes.data());
    return lanes;
}
std::array<float, lane_count> lanes_of(FloatLanes x) {
    std::array<float, lane_count> lanes;
    store(x, lanes.data());
    return lanes;
}

std::array<std::uint32_t, lane_count> some_words(std::uint64_t i) {
    std::array<std::uint32_t, lane_count> words;
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) words[lane] = philox(3, i, lane, 0)[lane % 4];
    return words;
}

TEST(WordLanes, DoWhatWordsDo) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const auto a = some_words(2 * i), b = some_words(2 * i + 1);
        const WordLanes x = load_words(a.data()), y = load_words(b.data());
        const auto sum = lanes_of(x + y), difference = lanes_of(x - y), product = lanes_of(x * y);
        const auto shifted = lanes_of((x << 5) ^ (y >> 7)), chosen = lanes_of(select(below(x >> 1, y >> 1), x, y));
        const auto high = lanes_of(wide_product(x, b[0]).high), low = lanes_of(wide_product(x, b[0]).low);
        const auto third = lanes_of(third_of(x >> 1));
        const unsigned top = bits_of(has_top_bit(x)), equals = bits_of(equal(x & WordLanes(1u), y & WordLanes(1u)));
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            EXPECT_EQ(sum[lane], a[lane] + b[lane]);
            EXPECT_EQ(difference[lane], a[lane] - b[lane]);
            EXPECT_EQ(product[lane], a[lane] * b[lane]);
            EXPECT_EQ(shifted[lane], (a[lane] << 5) ^ (b[lane] >> 7));
            EXPECT_EQ(chosen[lane], a[lane] >> 1 < b[lane] >> 1 ? a[lane] : b[lane]);
            EXPECT_EQ(std::uint64_t{high[lane]} << 32 | low[lane], std::uint64_t{a[lane]} * b[0]);
            EXPECT_EQ(top >> lane & 1u, a[lane] >> 31);
            EXPECT_EQ(third[lane], (a[lane] >> 1) / 3);
            EXPECT_EQ(equals >> lane & 1u, 1u ^ ((a[lane] ^ b[lane]) & 1u));
        }
    }
    EXPECT_EQ(bits_of(first_lanes(3)), 7u);
    EXPECT_EQ(bits_of(first_lanes(0)), 0u);
    const CountLanes counted = counted_from((std::uint64_t{6} << 32) - 3);
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
        EXPECT_EQ(lanes_of(counted.low)[lane], lane - 3);
        EXPECT_EQ(lanes_of(counted.high)[lane], lane < 3 ? 5u : 6u);
    }
}

TEST(WordLanes, GatherReadsEveryLaneItsOwn) {
    std::array<std::uint32_t, 64> table;
    for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = 1000 + i;
    const auto index = lanes_of(load_words(some_words(1).data()) & WordLanes(31u));
    const auto once = lanes_of(gather<1>(table.data(), load_words(index.data())));
    const auto twice = lanes_of(gather<2>(table.data() + 1, load_words(index.data())));
    const auto pair = gather_pair(table.data(), load_words(index.data()));
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        EXPECT_EQ(lanes_of(pair.first)[lane], 1000 + 2 * index[lane]);
        EXPECT_EQ(lanes_of(pair.second)[lane], 1001 + 2 * index[lane]);
        EXPECT_EQ(once[lane], 1000 + index[lane]);
        EXPECT_EQ(twice[lane], 1001 + 2 * index[lane]);
    }
}

TEST(WordLanes, RandomNumbersAreThoseOfOnePhoton) {
    for (std::uint64_t i = 0; i < 500; ++i) {
        const auto low = some_words(3 * i), high = some_words(3 * i + 1), bounce = some_words(3 * i + 2);
        const std::uint64_t seed = std::uint64_t{low[0]} << 32 | high[0];
        const auto words = philox(seed, load_words(low.data()), load_words(high.data()), load_words(bounce.data()), 7);
        const auto points = lanes_of(sobol_owen(load_words(low.data()), i % sobol_dimensions, load_words(high.data())));
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const auto alone = philox(seed, std::uint64_t{high[lane]} << 32 | low[lane], bounce[lane], 7);
            for (std::size_t word = 0; word < 4; ++word) EXPECT_EQ(lanes_of(words[word])[lane], alone[word]);
            EXPECT_EQ(lanes_of(unit_float(words[0]))[lane], unit_float(alone[0]));
            EXPECT_EQ(points[lane], sobol_owen(low[lane], i % sobol_dimensions, high[lane]));
        }
    }
}

TEST(Rows, TurnIntoColumnsAndBack) {
    std::array<Row, lane_count> rows, back;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
        for (std::size_t j = 0; j < row_size; ++j) rows[lane].x[j] = static_cast<float>(10 * lane + j);
    const Columns columns = load_columns([&](int lane) { return rows[static_cast<std::size_t>(lane)].x.data(); });
    store_columns(columns, [&](int lane) { return back[static_cast<std::size_t>(lane)].x.data(); });
    for (std::size_t lane = 0; lane < lane_count; ++lane)
        for (std::size_t j = 0; j < row_size; ++j) {
            EXPECT_EQ(lanes_of(columns[j])[lane], rows[lane].x[j]);
            EXPECT_EQ(back[lane].x[j], rows[lane].x[j]);
        }
}

// Of any size, ties included, up to the largest weight.
TEST(Rows, QuantaAreThoseOfOneWeight) {
    std::array<float, 16> weights;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const auto words = some_words(i);
        weights[i] = std::ldexp(unit_float(words[0]) - 0.5f, static_cast<int>(words[1] % 60) - 38);
    }
    weights[3] = 0x3p-31f;
    weights[5] = -0x1.fffffep20f;
    QuantaLanes lanes;
    lanes.add(first_lanes(5), load<FloatLanes>(weights.data()));
    lanes.subtract(first_lanes(2), load<FloatLanes>(weights.data() + 8));
    Quanta expected = -to_quanta(weights[8]) - to_quanta(weights[9]);
    for (std::size_t lane = 0; lane < 5; ++lane) expected += to_quanta(weights[lane]);
    EXPECT_EQ(lanes.total(), expected);
}

}  // namespace
}  // namespace brewster
