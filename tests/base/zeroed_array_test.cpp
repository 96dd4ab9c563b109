#include "base/zeroed_array.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace brewster {
namespace {

TEST(ZeroedArray, KeepsWhatItHoldsAndAddsZeros) {
    ZeroedArray<std::int64_t> numbers(3);
    numbers[2] = 7;
    for (const std::size_t size : {100u, 5000u, 1u << 20}) {
        const std::size_t before = numbers.size();
        numbers.resize(size);
        ASSERT_EQ(numbers.size(), size);
        EXPECT_EQ(numbers[2], 7);
        for (std::size_t i = before; i < size; ++i) ASSERT_EQ(numbers[i], 0) << i;
    }
    numbers.resize(5);
    EXPECT_EQ(numbers.size(), 1u << 20);
}

TEST(ZeroedArray, MovesItsPages) {
    ZeroedArray<double> from(10);
    from[9] = 0.5;
    const double* const pages = from.data();
    ZeroedArray<double> to = std::move(from);
    EXPECT_EQ(to.data(), pages);
    EXPECT_EQ(to[9], 0.5);
    EXPECT_EQ(ZeroedArray<double>().size(), 0u);
}

}  // namespace
}  // namespace brewster
