#include "app/picture_names.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace brewster {
namespace {

std::vector<std::string> paths(const std::string& path_template, const std::vector<std::string>& cameras) {
    std::vector<std::string> list;
    for (const PictureName& picture : name_pictures(path_template, cameras, {Map::radiance}))
        list.push_back(picture.path);
    return list;
}

TEST(PictureNames, PlaceholdersAreFilled) {
    EXPECT_EQ(paths("out/{camera}-{map}.png", {"front", "low"}),
              (std::vector<std::string>{"out/front-radiance.png", "out/low-radiance.png"}));
    EXPECT_EQ(paths("{camera}/{camera}.EXR", {"a b"}), (std::vector<std::string>{"a b/a b.EXR"}));
    EXPECT_EQ(paths("one.png", {"front"}), (std::vector<std::string>{"one.png"}));
}

TEST(PictureNames, CameraCannotLeaveTheFolder) {
    EXPECT_EQ(paths("out/{camera}.png", {"../../x"}), (std::vector<std::string>{"out/.._.._x.png"}));
}

TEST(PictureNames, EqualNamesAreRefused) {
    EXPECT_THROW(paths("one.png", {"front", "low"}), Error);
    EXPECT_THROW(paths("{camera}.png", {"front", "front"}), Error);
    EXPECT_THROW(paths("{camera}.png", {"a/b", "a_b"}), Error);
}

TEST(PictureNames, UnknownPlaceholdersAndEndingsAreRefused) {
    EXPECT_THROW(paths("{scene}.png", {"front"}), Error);
    EXPECT_THROW(paths("{camera.png", {"front"}), Error);
    EXPECT_THROW(paths("picture.jpg", {"front"}), Error);
    EXPECT_THROW(paths("picture", {"front"}), Error);
}

TEST(PictureNames, KindFollowsTheEnding) {
    EXPECT_TRUE(is_exr("a/b.exr"));
    EXPECT_TRUE(is_exr("b.EXR"));
    EXPECT_FALSE(is_exr("exr.png"));
}

}  // namespace
}  // namespace brewster
