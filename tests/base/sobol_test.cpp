#include "base/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace brewster {
namespace {

// Any 2^k first points put one point in each of 2^k equal intervals, whatever the scramble.
TEST(Sobol, EveryDimensionIsStratified) {
    for (unsigned d = 0; d < sobol_dimensions; ++d) {
        for (const std::uint32_t scramble : {1u, 0x9e3779b9u, 0xffffffffu}) {
            for (unsigned k = 1; k <= 10; ++k) {
                std::vector<int> counts(1u << k);
                for (std::uint32_t i = 0; i < (1u << k); ++i) ++counts[sobol_owen(i, d, scramble) >> (32 - k)];
                for (const int count : counts) ASSERT_EQ(count, 1) << "dimension " << d << ", 2^" << k;
            }
        }
    }
}

// The first two dimensions are a (0, 2)-sequence: one point in every elementary box of the square.
TEST(Sobol, FirstPairIsStratifiedInEveryBox) {
    constexpr unsigned k = 8;
    for (unsigned a = 0; a <= k; ++a) {
        std::vector<int> counts(1u << k);
        for (std::uint32_t i = 0; i < (1u << k); ++i) {
            const std::uint64_t x = sobol_owen(i, 0, 77), y = sobol_owen(i, 1, 4242);
            ++counts[((x >> (32 - a)) << (k - a)) + (y >> (32 - (k - a)))];
        }
        for (const int count : counts) ASSERT_EQ(count, 1) << "boxes of 2^-" << a;
    }
}

// Scrambles are independent: point 5 of dimension 3 is uniform over them. Chi-square of 15 degrees below 44.3 (1e-4).
TEST(Sobol, ScramblesAreUniform) {
    std::vector<int> counts(16);
    constexpr int n = 16000;
    for (std::uint32_t seed = 0; seed < n; ++seed) ++counts[sobol_owen(5, 3, scramble_of(seed, 1, 3)) >> 28];
    double chi_square = 0;
    for (const int count : counts) chi_square += std::pow(count - n / 16.0, 2) / (n / 16.0);
    EXPECT_LT(chi_square, 44.3);
    EXPECT_GT(chi_square, 2.0);  // and not suspiciously even: below 2 with probability 2e-5
}

}  // namespace
}  // namespace brewster
