#include "image/png.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "temporary_folder.h"

namespace brewster {
namespace {

TEST(Png, RoundTripKeepsEveryByteButAlpha) {
    const TemporaryFolder folder;
    ScreenImage image{7, 5, {}};
    for (int i = 0; i < 35; ++i) {
        for (const int byte : {i * 7, 255 - i, i * i, 255}) image.rgba.push_back(static_cast<std::uint8_t>(byte));
    }
    write_png(folder.file("a.png"), image);
    const ScreenImage again = read_png(folder.file("a.png"));
    EXPECT_EQ(again.width, 7);
    EXPECT_EQ(again.height, 5);
    EXPECT_EQ(again.rgba, image.rgba);
}

TEST(Png, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_png(folder.file("missing.png")), Error);
    std::ofstream(folder.file("text.png")) << "not a picture";
    EXPECT_THROW(read_png(folder.file("text.png")), Error);
    EXPECT_THROW(write_png(folder.file("no/such/folder.png"), ScreenImage{1, 1, {0, 0, 0, 0}}), Error);
}

}  // namespace
}  // namespace brewster
