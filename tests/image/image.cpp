#include "image/image.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace brewster {
namespace {

TEST(Image, NewChannelIsZeroEverywhere) {
    Image image(3, 2);
    EXPECT_FALSE(image.has("S0.R"));
    EXPECT_EQ(image.add_channel("S0.R"), std::vector<float>(6, 0.0f));
    EXPECT_TRUE(image.has("S0.R"));
}

TEST(Image, UnknownChannelNamesThoseThereAre) {
    Image image(1, 1);
    image.add_channel("S0.R");
    image.add_channel("V0.R");
    try {
        image.channel("S1.R");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("S1.R"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("S0.R V0.R"), std::string::npos);
    }
}

TEST(Image, ChannelNames) {
    EXPECT_EQ(stokes_channel(0, 0), "S0.R");
    EXPECT_EQ(stokes_channel(2, 1), "S2.G");
    EXPECT_EQ(variance_channel(3, 2), "V3.B");
}

TEST(ImageDeathTest, BandOutOfRangeBreaksTheContract) {
    EXPECT_DEATH(stokes_channel(0, 3), "band");
}

}  // namespace
}  // namespace brewster
