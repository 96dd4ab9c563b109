#include "app/newer_bins.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(NewerBins, WaitUntilTheMeanHasItsDraws) {
    EXPECT_EQ(newer_bins(1000, 2000, 0), Newer::wait);
    EXPECT_EQ(newer_bins(1000, 2000, draws_before_change - 1), Newer::wait);
    EXPECT_EQ(newer_bins(1000, 2000, draws_before_change), Newer::after_draws);
}

TEST(NewerBins, FarBetterOnesAreTakenAtOnceHoweverSlowlyThePictureIsDrawn) {
    EXPECT_EQ(newer_bins(1000, 3999, 1), Newer::wait);
    EXPECT_EQ(newer_bins(1000, 4000, 1), Newer::at_once);
    EXPECT_EQ(newer_bins(1000, 4000, 0), Newer::wait) << "the old ones are seen once at least";
    EXPECT_EQ(newer_bins(1000, 4000, 20), Newer::at_once);
}

}  // namespace
}  // namespace brewster
