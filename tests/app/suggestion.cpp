#include "app/suggestion.h"

#include <gtest/gtest.h>

#include <vector>

namespace brewster {
namespace {

const std::vector<std::string> names = {"front", "inside", "low"};

TEST(Suggestion, FindsTheNearMiss) {
    EXPECT_EQ(nearest_name("frnt", names), "front");
    EXPECT_EQ(nearest_name("Inside", names), "inside");
    EXPECT_EQ(nearest_name("lwo", names), "low");
    EXPECT_EQ(did_you_mean("insde", names), "; did you mean 'inside'?");
}

TEST(Suggestion, KeepsQuietAboutWhatIsFar) {
    EXPECT_EQ(nearest_name("ceiling", names), std::nullopt);
    EXPECT_EQ(nearest_name("fr", names), std::nullopt);
    EXPECT_EQ(nearest_name("", names), std::nullopt);
    EXPECT_EQ(did_you_mean("x", {}), "");
}

}  // namespace
}  // namespace brewster
