#include "image/blocks.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

Image ramp() {  // 5 x 3: 0 .. 14
    Image image(5, 3);
    std::vector<float>& pixels = image.add_channel("R");
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i);
    image.add_channel("V0.R").assign(15, 0.4f);
    return image;
}

TEST(Blocks, MeansOfBlocksAndOfWhatIsLeftAtTheBorders) {
    const Blocks blocks = block_means(ramp(), 2);
    EXPECT_EQ(blocks.image.width(), 3);
    EXPECT_EQ(blocks.image.height(), 2);
    const std::vector<float> expected = {3, 5, 6.5f, 10.5f, 12.5f, 14};  // (0 + 1 + 5 + 6) / 4, ..., (4 + 9) / 2, ...
    EXPECT_EQ(blocks.image.channel("R"), expected);
    const std::vector<float> variances = {0.1f, 0.1f, 0.2f, 0.2f, 0.2f, 0.4f};
    for (std::size_t b = 0; b < 6; ++b) EXPECT_FLOAT_EQ(blocks.image.channel("V0.R")[b], variances[b]);
    EXPECT_EQ(blocks.mask, std::vector<std::uint8_t>(6, 1));
}

TEST(Blocks, MaskLeavesPixelsAndEmptyBlocksOut) {
    std::vector<std::uint8_t> mask(15, 0);
    mask[0] = mask[6] = mask[2] = 1;
    const Blocks blocks = block_means(ramp(), 2, mask);
    EXPECT_EQ(blocks.mask, (std::vector<std::uint8_t>{1, 1, 0, 0, 0, 0}));
    EXPECT_FLOAT_EQ(blocks.image.channel("R")[0], 3);
    EXPECT_FLOAT_EQ(blocks.image.channel("R")[1], 2);
    EXPECT_FLOAT_EQ(blocks.image.channel("V0.R")[0], 0.2f);
}

TEST(Blocks, SideOneChangesNothing) {
    EXPECT_EQ(block_means(ramp(), 1).image.channel("V0.R"), ramp().channel("V0.R"));
}

}  // namespace
}  // namespace brewster
