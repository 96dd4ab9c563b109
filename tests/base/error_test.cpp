#include "base/error.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace brewster {
namespace {

TEST(Error, SaysWhereWhatAndWhatToDo) {
    const Error error("no lamp gives light", "room.gltf", "add a light");
    EXPECT_STREQ(error.what(), "room.gltf: no lamp gives light; add a light");
}

TEST(CheckDeathTest, NamesTheBrokenContractWithItsValues) {
    const int photons = 3;
    EXPECT_DEATH(BREWSTER_CHECK(photons > 5, "photons = " + std::to_string(photons)), "photons > 5, but photons = 3");
    BREWSTER_CHECK(photons == 3, "unused");
}

}  // namespace
}  // namespace brewster
