#include "app/settling_picture.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

GatheredTile tile(int left, int top, int width, int height, double draws) {
    GatheredTile tile{{left, top, StokesPicture(width, height)}, 1000};
    tile.part.picture.draws = draws;
    return tile;
}

TEST(SettlingPicture, BecomesWholeTileByTile) {
    SettlingPicture picture({6, 4});
    EXPECT_EQ(picture.share(), 0);
    EXPECT_EQ(picture.samples(), 0);
    picture.count(tile(4, 0, 2, 4, 4));
    EXPECT_NEAR(picture.share(), 1.0 / 3, 1e-12);
    EXPECT_EQ(picture.samples(), 4) << "where a tile has come";
    EXPECT_FALSE(picture.whole());
    EXPECT_TRUE(picture.covers({4, 0}, {6, 4}));
    EXPECT_FALSE(picture.covers({3, 0}, {6, 4}));
    picture.count(tile(0, 0, 4, 4, 8));
    EXPECT_TRUE(picture.whole());
    EXPECT_TRUE(picture.covers({0, 0}, {6, 4}));
    EXPECT_NEAR(picture.samples(), (8 * 4 + 16 * 8) / 24.0, 1e-6);
    EXPECT_EQ(picture.photons(), 1000u);
}

TEST(SettlingPicture, ATileThatComesAgainCountsOnce) {
    SettlingPicture picture({4, 2});
    picture.count(tile(0, 0, 4, 2, 4));
    picture.count(tile(2, 0, 2, 2, 8));
    EXPECT_TRUE(picture.whole());
    EXPECT_EQ(picture.share(), 1);
    EXPECT_NEAR(picture.samples(), 6, 1e-6);
}

}  // namespace
}  // namespace brewster
