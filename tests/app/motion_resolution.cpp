#include "app/motion_resolution.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(MotionResolution, HalvesWhenSlowAndComesBackWhenFast) {
    MotionResolution resolution;
    resolution.frame_took(0.05);
    EXPECT_FALSE(resolution.half());
    resolution.frame_took(0.07);
    EXPECT_TRUE(resolution.half());
    resolution.frame_took(0.02);  // a full picture would take 80 ms
    EXPECT_TRUE(resolution.half());
    resolution.frame_took(0.01);
    EXPECT_FALSE(resolution.half());
}

}  // namespace
}  // namespace brewster
