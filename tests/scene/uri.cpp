#include "scene/uri.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(Uri, PercentSignsAreDecoded) {
    EXPECT_EQ(decoded_uri("a%20b%2Fc%c3%A4"), "a b/c\xc3\xa4");
    EXPECT_EQ(decoded_uri("100%"), "100%");
    EXPECT_EQ(decoded_uri("%zz%4"), "%zz%4");
    EXPECT_EQ(decoded_uri("%41"), "A");
}

TEST(Uri, OnlyPathsThatGoDown) {
    for (const char* fine : {"a.bin", "my%20folder/a b.png", "a/b/c.bin", "..a/b", "a..b", "data:;base64,AA==", "./a"})
        EXPECT_TRUE(stays_below(fine)) << fine;
    for (const char* foul : {"", "/a", "../a", "a/../../b", "%2e%2e/a", "..\\a", "\\\\host\\a", "file:///a",
                             "http://a/b", "C:\\a", "C:a", "%2Fetc", "a%00b", "a/.."})
        EXPECT_FALSE(stays_below(foul)) << foul;
}

}  // namespace
}  // namespace brewster
