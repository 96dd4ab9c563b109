#include "app/settings.h"

#include <gtest/gtest.h>

#include "app/trace.h"
#include "base/error.h"

namespace brewster {
namespace {

std::string words_of(const std::string& text) {
    Scene scene = *load_scene("", {});
    try {
        apply_settings(scene, {*parse_setting(text)});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Settings, SplitAtTheLastDotBeforeTheLastEqualSign) {
    const auto setting = parse_setting("wall.001 a=b.roughness=0.35");
    ASSERT_TRUE(setting);
    EXPECT_EQ(setting->owner, "wall.001 a=b");
    EXPECT_EQ(setting->property, "roughness");
    EXPECT_EQ(setting->value, "0.35");
    for (const char* wrong : {"", "wall", "wall.roughness", "wall=0.3", ".roughness=1", "wall.=1", "wall.n="})
        EXPECT_FALSE(parse_setting(wrong)) << wrong;
}

TEST(Settings, ChangeTheSceneInTheirOrder) {
    const auto scene =
        load_scene("", {{"red", "n", "1.5"}, {"red", "roughness", "0.5"}, {"lamp", "emission", "1,2,3"}});
    const auto material = [&](const std::string& name) {
        for (const Material& candidate : scene->materials)
            if (candidate.name == name) return candidate;
        return Material{};
    };
    EXPECT_FLOAT_EQ(material("red").interface.slope, 0.25f);
    EXPECT_EQ(material("lamp").emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene->lamps.front().intensity, glm::vec3(1, 2, 3));
}

TEST(Settings, NearMissesAreSuggested) {
    EXPECT_NE(words_of("rde.n=1.5").find("did you mean 'red'?"), std::string::npos);
    EXPECT_NE(words_of("red.albdo=1").find("did you mean 'albedo'?"), std::string::npos);
    EXPECT_NE(words_of("red.colour=1").find("it has albedo, medium, n"), std::string::npos) << words_of("red.colour=1");
    EXPECT_NE(words_of("red.n=x").find("red.n: 'x' is not its value"), std::string::npos);
    EXPECT_EQ(words_of("red.n=1.5"), "");
}

}  // namespace
}  // namespace brewster
