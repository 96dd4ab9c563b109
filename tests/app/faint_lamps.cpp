#include "app/faint_lamps.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

Lamp lamp_of(const char* name, float power) {
    Lamp lamp;
    lamp.name = name;
    lamp.power = glm::vec3(power);
    return lamp;
}

TEST(FaintLamps, ThoseThatStartNoPhotonsAreNamed) {
    Scene scene;
    scene.lamps = {lamp_of("sun", 1e6f), lamp_of("candle", 1), lamp_of("off", 0), lamp_of("panel", 5),
                   lamp_of("panel", 6)};  // together as bright as it takes
    EXPECT_EQ(faint_lamps(scene, 1e6), std::vector<std::string>{"candle"});
    EXPECT_TRUE(faint_lamps(scene, 2e7).empty());
}

}  // namespace
}  // namespace brewster
