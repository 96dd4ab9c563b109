#include "base/philox.h"

#include <gtest/gtest.h>

#include <set>

namespace brewster {
namespace {

// Known answers of Philox4x32-10 (Random123's kat_vectors).
TEST(Philox, KnownAnswers) {
    EXPECT_EQ(philox(0, 0, 0, 0), (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox(~0ull, ~0ull, ~0u, ~0u),
              (std::array<std::uint32_t, 4>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox(0x299f31d0a4093822ull, 0x85a308d3243f6a88ull, 0x13198a2e, 0x03707344),
              (std::array<std::uint32_t, 4>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, EveryKeyWordMatters) {
    std::set<std::uint32_t> words;
    for (const std::uint64_t seed : {0ull, 1ull, 1ull << 32, ~0ull})
        for (const std::uint64_t photon : {0ull, 1ull, 1ull << 32, ~0ull})
            for (const std::uint32_t bounce : {0u, 1u, ~0u})
                for (const std::uint32_t draw : {0u, 1u}) words.insert(philox(seed, photon, bounce, draw)[0]);
    EXPECT_EQ(words.size(), 4u * 4u * 3u * 2u);
}

TEST(UnitFloat, StaysBelowOne) {
    EXPECT_EQ(unit_float(0), 0.0f);
    EXPECT_LT(unit_float(~0u), 1.0f);
    EXPECT_EQ(unit_float(0x80000000u), 0.5f);
}

}  // namespace
}  // namespace brewster
