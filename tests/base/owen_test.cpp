#include "base/owen.h"

#include <gtest/gtest.h>

#include <set>

namespace brewster {
namespace {

/// The first 2^k points hit every elementary box of area 2^-k once, whatever the key.
TEST(SobolPair, PrefixesAreNets) {
    for (const std::uint32_t key : {0u, 1u, 0xdeadbeefu})
        for (unsigned k = 0; k <= 8; ++k)
            for (unsigned columns = 0; columns <= k; ++columns) {
                std::set<std::uint32_t> boxes;
                for (std::uint32_t i = 0; i < 1u << k; ++i) {
                    const auto point = sobol_pair(i, key);
                    const auto cell = [](std::uint32_t x, unsigned bits) { return bits == 0 ? 0 : x >> (32 - bits); };
                    boxes.insert(cell(point[0], columns) << 16 | cell(point[1], k - columns));
                }
                EXPECT_EQ(boxes.size(), 1u << k) << key << " " << k << " " << columns;
            }
}

/// Pairs of two keys together are no better spread than chance: 4096 points in 16 x 16 boxes of their first coordinates,
/// chi-square of 255 degrees of freedom within 5 of its standard deviations (22.6); equal keys leave boxes empty.
TEST(SobolPair, OtherKeysAreIndependent) {
    const auto chi_square = [](std::uint32_t key_a, std::uint32_t key_b) {
        std::array<int, 256> counts{};
        for (std::uint32_t i = 0; i < 4096; ++i)
            ++counts[(sobol_pair(i, key_a)[0] >> 28) * 16 + (sobol_pair(i, key_b)[0] >> 28)];
        double sum = 0;
        for (const int count : counts) sum += (count - 16) * (count - 16) / 16.0;
        return sum;
    };
    EXPECT_NEAR(chi_square(1, 2), 255, 5 * 22.6);
    EXPECT_NEAR(chi_square(77, 1234567), 255, 5 * 22.6);
    EXPECT_GT(chi_square(5, 5), 10000);
}

}  // namespace
}  // namespace brewster
