#include "base/fixed_point.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(FixedPoint, RoundsToEvenOnce) {
    EXPECT_EQ(to_quanta(1.0f), Quanta{1} << 30);
    EXPECT_EQ(to_quanta(0x1p-31), 0);
    EXPECT_EQ(to_quanta(0x3p-31), 2);
    EXPECT_EQ(to_quanta(-0x3p-31), -2);
    EXPECT_EQ(to_weight(Wide{3} << 29), 1.5);
}

// 1e12 photons of weight 4 in one cell.
TEST(FixedPoint, HoldsTenToTheTwelfthPhotons) {
    const Wide whole = Wide{to_quanta(4.0f)} * 1'000'000'000'000;
    EXPECT_EQ(to_weight(whole), 4e12);
}

}  // namespace
}  // namespace brewster
