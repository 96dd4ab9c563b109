#include "image/difference.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace brewster {
namespace {

Image grey(const std::vector<float>& values) {
    Image image(static_cast<int>(values.size()), 1);
    for (const char letter : band_letters) image.add_channel(std::string(1, letter)) = values;
    return image;
}

TEST(Difference, SubtractsValuesAndAddsVariances) {
    Image a = grey({1, 2}), b = grey({3, 2});
    a.add_channel("V0.R") = {0.1f, 0.2f};
    b.add_channel("V0.R") = {0.3f, 0.1f};
    a.add_channel("S3.G");
    const Image difference = difference_image(a, b);
    EXPECT_EQ(difference.channel("G"), (std::vector<float>{-2, 0}));
    EXPECT_FLOAT_EQ(difference.channel("V0.R")[0], 0.4f);
    EXPECT_FALSE(difference.has("S3.G"));
}

TEST(Difference, MapIsWhiteWhereEqualOrangeAboveBlueBelow) {
    const ScreenImage map = difference_map(grey({1, 2, 0.5f, 1.05f}), grey({1, 1, 1, 1}), 0.01, 0.1);
    const auto pixel = [&](std::size_t i) {
        return std::array<int, 3>{map.rgba[4 * i], map.rgba[4 * i + 1], map.rgba[4 * i + 2]};
    };
    EXPECT_EQ(pixel(0), (std::array<int, 3>{255, 255, 255}));
    EXPECT_GT(pixel(1)[0], pixel(1)[2] + 150);
    EXPECT_GT(pixel(2)[2], pixel(2)[0] + 150);
    EXPECT_NEAR(pixel(3)[2], (255 + pixel(1)[2]) / 2, 1);  // 5 % is half of the full scale
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(map.rgba[4 * i + 3], 255);
}

TEST(Difference, NeedsOneSizeAndACommonChannel) {
    EXPECT_THROW(difference_image(grey({1}), grey({1, 2})), Error);
    EXPECT_THROW(difference_map(grey({1}), grey({1, 2}), 0.01, 0.1), Error);
    Image other(1, 1);
    other.add_channel("Z");
    EXPECT_THROW(difference_image(grey({1}), other), Error);
}

}  // namespace
}  // namespace brewster
