#include "base/error.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace brewster {
namespace {

TEST(Error, SaysWhereWhatAndWhatToDo) {
    const Error error("no lamp gives light", "room.gltf", "add a light");
    EXPECT_STREQ(error.what(), "room.gltf: no lamp gives light; add a light");
}

// Names in files may hold anything; a message stays one line that ends where it ends.
TEST(Error, StaysOnOneLine) {
    const Error error("there is no \x1b[31m'a\nb'", std::string("a\0b", 3), "look\tagain \xc3\xa9");
    EXPECT_STREQ(error.what(), "a b: there is no  [31m'a b'; look again \xc3\xa9");
}

TEST(CheckDeathTest, NamesTheBrokenContractWithItsValues) {
    const int photons = 3;
    EXPECT_DEATH(BREWSTER_CHECK(photons > 5, "photons = " + std::to_string(photons)), "photons > 5, but photons = 3");
    BREWSTER_CHECK(photons == 3, "unused");
}

}  // namespace
}  // namespace brewster
