#include "app/material_summary.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(MaterialSummary, SaysWhatAMaterialIsMadeOf) {
    const Scene scene;
    Material paint;
    paint.albedo = {0.5f, 0.25f, 0.5f};
    EXPECT_EQ(described(scene, paint), "Lambert, albedo 0.5 0.25 0.5");
    EXPECT_FALSE(polarizes(paint).yes);

    Material glossy;
    glossy.base = Base::polarized_diffuse;
    glossy.albedo = glm::vec3(0.8f);
    glossy.interface = {InterfaceKind::dielectric, Finish::beckmann, glm::vec3(1.5f), glm::vec3(0), 0.25f, 0, 0};
    glossy.double_sided = true;
    EXPECT_EQ(described(scene, glossy),
              "dielectric n 1.5, rough with m 0.25, over a diffuse base of albedo 0.8, both sides");
    EXPECT_TRUE(polarizes(glossy).yes);

    Material metal;
    metal.base = Base::black;
    metal.interface = {InterfaceKind::conductor, Finish::kirchhoff, {0.2f, 0.4f, 1.5f}, glm::vec3(3), 0.5f, 0.1f, 0.4f};
    EXPECT_EQ(described(scene, metal),
              "conductor n 0.2 0.4 1.5, k 3, rough with heights of 0.1 um rms over 0.4 um (m 0.5)");
    EXPECT_TRUE(polarizes(metal).yes);

    Material sheet;
    sheet.base = Base::transparent;
    sheet.thin = true;
    EXPECT_FALSE(polarizes(sheet).yes);
    sheet.filter = {FilterKind::polarizer, 0.785398163f, {}};
    EXPECT_EQ(described(scene, sheet), "linear polarizer that passes light at 45 degrees");
    EXPECT_TRUE(polarizes(sheet).yes);
}

TEST(MaterialSummary, TexturesAndHolesAreThere) {
    Scene scene;
    SurfaceTexture texture;
    texture.width = 2;
    texture.height = 1;
    texture.texels =
        std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 0});
    scene.textures.push_back(texture);
    Material lattice;
    lattice.texture = 0;
    lattice.alpha_cutoff = 0.5f;
    EXPECT_EQ(described(scene, lattice),
              "Lambert, albedo 0.8, times a texture of 2 x 1 (mean 0.5), cut out where alpha is below 0.5");
}

}  // namespace
}  // namespace brewster
