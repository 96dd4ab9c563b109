#include "scene/needs.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

Scene canonical(const std::string& name) {
    return read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/" + name + ".gltf");
}

TEST(Needs, OfTheCanonicalScenes) {
    struct Expected {
        const char* scene;
        int stokes, bands;
    };
    for (const Expected& expected : {Expected{"cornell-box", 1, 3},
                                     {"furnace", 1, 1},
                                     {"brewster-room", 3, 3},
                                     {"gloss-lab", 3, 3},
                                     {"metal-lab", 4, 3},
                                     {"spheres", 3, 1}}) {
        const Needs needs = needs_of(canonical(expected.scene));
        EXPECT_EQ(needs.stokes, expected.stokes) << expected.scene;
        EXPECT_EQ(needs.bands, expected.bands) << expected.scene;
        EXPECT_FALSE(needs.polarized_lamps);
        EXPECT_EQ(needs.reasons.size(), 2u);
    }
}

TEST(Needs, AMetalAloneMakesNothingCircular) {
    Scene scene = canonical("cornell-box");
    Material& metal = scene.materials[scene.charts[scene.charts_of("floor")[0]].material];
    // "floor", "back" and "ceiling" share their material: give the floor one of its own.
    scene.materials.push_back(metal);
    Material& mirror = scene.materials.back();
    mirror.interface.kind = InterfaceKind::conductor;
    mirror.base = Base::black;
    scene.charts[scene.charts_of("floor")[0]].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    EXPECT_EQ(needs_of(scene).stokes, 3);
    scene.charts[scene.charts_of("left")[0]].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    EXPECT_EQ(needs_of(scene).stokes, 4);
}

TEST(Needs, PolarizedLampsCountWhereSomethingCanTell) {
    Scene box = canonical("cornell-box");
    box.lamps[0].polarization = {0.5f, 0.0f, 0.2f};
    EXPECT_EQ(needs_of(box).stokes, 1);
    Scene room = canonical("brewster-room");
    room.lamps[0].polarization = {0.5f, 0.0f, 0.0f};
    EXPECT_EQ(needs_of(room).stokes, 3);
    EXPECT_TRUE(needs_of(room).polarized_lamps);
    room.lamps[0].polarization = {0.0f, 0.0f, 0.1f};
    EXPECT_EQ(needs_of(room).stokes, 4);
}

TEST(Needs, OneBandKeepsTheColourOfTheLight) {
    Scene furnace = canonical("furnace");
    for (Lamp& lamp : furnace.lamps) lamp.power *= glm::vec3(2, 1, 0.5f);
    const Needs needs = needs_of(furnace);
    EXPECT_EQ(needs.bands, 1);
    EXPECT_NEAR(needs.colour.x / needs.colour.z, 4.0f, 1e-5f);
    EXPECT_NEAR((needs.colour.x + needs.colour.y + needs.colour.z) / 3, 1.0f, 1e-6f);
    furnace.lamps[3].power.x *= 1.1f;
    EXPECT_EQ(needs_of(furnace).bands, 3);
}

}  // namespace
}  // namespace brewster
