#include "scene/prepared_material.h"

#include <gtest/gtest.h>

#include "scene/test_materials.h"

namespace brewster {
namespace {

using namespace test_materials;

TEST(PreparedMaterial, ContradictionsAreBrokenContracts) {
    EXPECT_DEATH(prepare_materials({named(dielectric(Base::lambert), "varnish")}), "varnish");
    EXPECT_DEATH(prepare_materials({over(InterfaceKind::conductor, {1, 1, 1}, {3, 3, 3}, Base::polarized_diffuse)}),
                 "");
    EXPECT_DEATH(prepare_materials({beckmann(dielectric(Base::transparent), 0.2f)}), "");
    EXPECT_DEATH(prepare_materials({beckmann(gold(), 0.0f)}), "");
}

TEST(PreparedMaterial, LambertIsARhoOverPi) {
    const PreparedMaterial material = prepare_materials({lambert()})[0];
    EXPECT_NEAR(static_cast<double>(material.base_factor[0]), 0.8 / pi, 1e-7);
    EXPECT_FLOAT_EQ(material.base_survival[1], 0.5f);
    EXPECT_EQ(material.passage(0, 0.3).unpolarized, 1);
    EXPECT_FALSE(material.sharp());
}

/// A tinted base is the base of a material with that albedo.
TEST(PreparedMaterial, TintsAreAlbedos) {
    Material dark = dielectric(Base::polarized_diffuse);
    dark.albedo *= 0.3f;
    const auto materials = prepare_materials({dielectric(Base::polarized_diffuse), dark});
    for (std::size_t band = 0; band < band_count; ++band)
        EXPECT_NEAR(materials[0].tinted_base(band, 0.3) * static_cast<double>(materials[0].base_factor[band]),
                    static_cast<double>(materials[1].base_factor[band]), 1e-8);
}

/// Two walls of one index share a table unless wave optics tells the bands apart.
TEST(PreparedMaterial, BandsOfOneIndexPassTheSame) {
    const auto materials = prepare_materials({beckmann(dielectric(Base::polarized_diffuse), 0.3f),
                                              kirchhoff(dielectric(Base::polarized_diffuse), 0.1f, 1.0f)});
    EXPECT_TRUE(materials[0].achromatic);
    EXPECT_EQ(materials[0].passage(0, 0.4).unpolarized, materials[0].passage(2, 0.4).unpolarized);
    EXPECT_NE(materials[1].passage(0, 0.4).unpolarized, materials[1].passage(2, 0.4).unpolarized);
}

/// 4 pi sigma / lambda for 0.1 um at 612 nm, and m = 2 sigma / tau.
TEST(PreparedMaterial, WaveOpticsHasItsUnits) {
    const PreparedMaterial material = prepare_materials({kirchhoff(gold(), 0.1f, 2.0f)})[0];
    EXPECT_NEAR(static_cast<double>(material.phase[0]), 4 * pi * 100 / 612, 1e-5);
    EXPECT_FLOAT_EQ(material.slope, 0.1f);
    EXPECT_FALSE(material.achromatic);
}

}  // namespace
}  // namespace brewster
