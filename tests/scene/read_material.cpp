#include "scene/read_material.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "scene/gltf_builder.h"
#include "scene/scene.h"

namespace brewster {
namespace {

using Warnings = std::vector<std::string>;

GltfMaterial plastic() {
    GltfMaterial from;
    from.name = "it";
    from.base_color = {0.2, 0.4, 0.6, 1};
    from.metallic = 0;
    from.roughness = 0.5;
    return from;
}

Material read(const GltfMaterial& from, std::size_t sentences) {
    Warnings warnings;
    const Material material = read_material(from, 0, warnings);
    EXPECT_EQ(warnings.size(), sentences) << (warnings.empty() ? "" : warnings[0]);
    return material;
}

void expect_bands(glm::vec3 a, glm::vec3 b, float tolerance) {
    for (int band = 0; band < 3; ++band) EXPECT_NEAR(a[band], b[band], tolerance) << "band " << band;
}

TEST(ReadMaterial, PlasticIsADielectricOverAPolarizedDiffuseBase) {
    const Material material = read(plastic(), 0);
    EXPECT_EQ(material.interface.kind, InterfaceKind::dielectric);
    EXPECT_EQ(material.interface.finish, Finish::beckmann);
    EXPECT_FLOAT_EQ(material.interface.slope, 0.25f);  // m = r^2
    expect_bands(material.interface.n, glm::vec3(1.5f), 1e-6f);
    EXPECT_EQ(material.base, Base::polarized_diffuse);
    expect_bands(material.albedo, {0.2f, 0.4f, 0.6f}, 1e-6f);
}

TEST(ReadMaterial, BlackPlasticHasABlackBase) {
    GltfMaterial from = plastic();
    from.base_color = {0, 0, 0, 1};
    from.roughness = 0;
    const Material material = read(from, 0);
    EXPECT_EQ(material.base, Base::black);
    EXPECT_EQ(material.interface.finish, Finish::smooth);
}

TEST(ReadMaterial, SpecularFactorScalesTheReflectance) {
    GltfMaterial from = plastic();
    from.specular = 0.25;
    expect_bands(normal_reflectance(read(from, 0).interface), glm::vec3(0.01f), 1e-7f);  // a quarter of 0.04
    from.specular = 0;
    const Material bare = read(from, 0);
    EXPECT_FALSE(bare.interface.present());
    EXPECT_EQ(bare.base, Base::lambert);
    expect_bands(bare.albedo, {0.2f, 0.4f, 0.6f}, 1e-6f);
}

TEST(ReadMaterial, SpecularColourScalesItBandByBand) {
    GltfMaterial from = plastic();
    from.specular_color = {1, 0.25, 0};
    const Material material = read(from, 0);
    expect_bands(normal_reflectance(material.interface), {0.04f, 0.01f, 0}, 3e-5f);  // the last: an index of 1.01
    EXPECT_EQ(material.interface.kind, InterfaceKind::dielectric);
    from.specular_color = {1e6, 1e6, 1e6};
    expect_bands(normal_reflectance(read(from, 0).interface), glm::vec3(0.96f), 1e-3f);
}

// A surface is a metal or none, transparent or not; what lies between is said.
TEST(ReadMaterial, HalfWaysAreSaid) {
    GltfMaterial from = plastic();
    from.metallic = 0.3;
    EXPECT_EQ(read(from, 1).interface.kind, InterfaceKind::dielectric);
    from.metallic = 0.7;
    EXPECT_EQ(read(from, 1).interface.kind, InterfaceKind::conductor);
    from.metallic = 0;
    from.transmission = 0.3;
    EXPECT_EQ(read(from, 1).base, Base::polarized_diffuse);
}

TEST(ReadMaterial, IndicesBelowOneAreSaid) {
    GltfMaterial from = plastic();
    from.surface.n = {0.9, 1.2, 1.2};
    from.surface.k = {0, 0, 0};
    EXPECT_EQ(read(from, 1).interface.kind, InterfaceKind::none);
}

TEST(ReadMaterial, IndexOfAirIsNoInterface) {
    GltfMaterial from = plastic();
    from.ior = 1;
    EXPECT_EQ(read(from, 0).base, Base::lambert);
    from.ior = 0;  // a file of the old specular-glossiness kind
    expect_bands(read(from, 0).interface.n, glm::vec3(1.5f), 1e-6f);
}

TEST(ReadMaterial, RoughnessBeyondTheTheoryIsClampedAndSaid) {
    GltfMaterial from = plastic();
    from.roughness = 1;
    EXPECT_FLOAT_EQ(read(from, 1).interface.slope, 0.8f);
    from.roughness = 0.894;
    EXPECT_NEAR(read(from, 0).interface.slope, 0.799f, 1e-3f);
}

TEST(ReadMaterial, MetalOfAColourReflectsThatColour) {
    GltfMaterial from = plastic();
    from.metallic = 1;
    for (const std::array<double, 3>& colour : {std::array<double, 3>{1.0, 0.77, 0.34},
                                                {0.95, 0.64, 0.54},
                                                {0.97, 0.96, 0.92},
                                                {0.56, 0.57, 0.58},
                                                {0.5, 0.1, 0.0},
                                                {0.0, 0.0, 0.0}}) {
        from.base_color = {colour[0], colour[1], colour[2], 1};
        const Material material = read(from, 0);
        EXPECT_EQ(material.interface.kind, InterfaceKind::conductor);
        EXPECT_EQ(material.base, Base::black);
        const glm::vec3 reflected = normal_reflectance(material.interface);
        for (int band = 0; band < 3; ++band) {
            EXPECT_NEAR(reflected[band], std::min(colour[static_cast<std::size_t>(band)], 0.99), 1e-5);
            if (colour[static_cast<std::size_t>(band)] < 0.5) {
                EXPECT_EQ(material.interface.n[band], 1.0f);
            }
        }
    }
}

TEST(ReadMaterial, ComplexIorHolds) {
    GltfMaterial from = plastic();
    from.metallic = 1;
    from.surface.n = {0.19, 0.43, 1.4};
    from.surface.k = {3.25, 2.46, 1.88};
    const Material gold = read(from, 0);
    EXPECT_EQ(gold.interface.kind, InterfaceKind::conductor);
    expect_bands(gold.interface.n, {0.19f, 0.43f, 1.4f}, 0.0f);
    expect_bands(gold.interface.k, {3.25f, 2.46f, 1.88f}, 0.0f);
    from.metallic = 0;  // k alone makes a conductor; without it, n is a dielectric's, band by band
    EXPECT_EQ(read(from, 0).interface.kind, InterfaceKind::conductor);
    from.surface.n = {1.51, 1.52, 1.53};
    from.surface.k = {0, 0, 0};
    const Material glass = read(from, 0);
    EXPECT_EQ(glass.interface.kind, InterfaceKind::dielectric);
    expect_bands(glass.interface.n, {1.51f, 1.52f, 1.53f}, 0.0f);
}

TEST(ReadMaterial, HeightAndLengthMakeAKirchhoffSurface) {
    GltfMaterial from = plastic();
    from.surface.rms_height = 0.2;
    from.surface.correlation_length = 2;
    const Interface interface = read(from, 0).interface;
    EXPECT_EQ(interface.finish, Finish::kirchhoff);
    EXPECT_FLOAT_EQ(interface.slope, 0.2f);  // 2 sigma / tau, whatever roughnessFactor says
    EXPECT_FLOAT_EQ(interface.rms_height, 0.2f);
    EXPECT_FLOAT_EQ(interface.correlation_length, 2.0f);
    from.surface.correlation_length = 0.25;
    const Interface clamped = read(from, 1).interface;
    EXPECT_FLOAT_EQ(clamped.slope, 0.8f);
    EXPECT_FLOAT_EQ(clamped.rms_height, 0.2f);
    EXPECT_FLOAT_EQ(clamped.correlation_length, 0.5f);
}

TEST(ReadMaterial, TransmissionIsAPaneOrABody) {
    GltfMaterial from = plastic();
    from.base_color = {1, 1, 1, 1};
    from.transmission = 1;
    from.roughness = 0;
    const Material pane = read(from, 0);
    EXPECT_EQ(pane.base, Base::transparent);
    EXPECT_TRUE(pane.thin);
    EXPECT_EQ(pane.interface.finish, Finish::smooth);
    expect_bands(pane.albedo, glm::vec3(0.0f), 0.0f);
    from.thickness = 0.01;
    EXPECT_FALSE(read(from, 0).thin);
    from.roughness = 0.1;
    from.attenuates = true;
    from.transmission = 0.9;
    EXPECT_EQ(read(from, 3).interface.finish, Finish::smooth);
    from.attenuates = false;
    from.base_color = {1, 0.5, 1, 1};  // a tint of its skin is as little simulated
    from.specular_color = {1, 0.5, 1};
    EXPECT_EQ(read(from, 4).interface.n.y, 1.5f);
}

TEST(ReadMaterial, FiltersAreBareSheets) {
    GltfMaterial from = plastic();
    from.surface.polarizer = true;
    from.surface.angle = 30;
    const Material polarizer = read(from, 0);
    EXPECT_EQ(polarizer.filter.kind, FilterKind::polarizer);
    EXPECT_FLOAT_EQ(polarizer.filter.angle, static_cast<float>(radians(30)));
    EXPECT_EQ(polarizer.base, Base::transparent);
    EXPECT_TRUE(polarizer.thin);
    EXPECT_FALSE(polarizer.interface.present());

    from.surface.polarizer = false;
    from.surface.retarder = true;
    from.surface.retardance = 450;
    expect_bands(read(from, 0).filter.retardance, glm::vec3(static_cast<float>(pi / 2)), 1e-6f);
    from.surface.retardance = 0;
    from.surface.birefringence = 0.009;
    from.surface.thickness = 61.0;  // a wave at 549 nm
    const glm::vec3 plate = read(from, 0).filter.retardance;
    EXPECT_NEAR(std::cos(plate.y), 1.0f, 1e-6f);
    EXPECT_NEAR(plate.x, 2 * pi * 549 / 612, 1e-5);
    EXPECT_NEAR(plate.z, 2 * pi * (549.0 / 465 - 1), 1e-5);
}

TEST(ReadMaterial, TheExtensionIsReadFromTheFile) {
    GltfBuilder file;
    file.add_material("gold", {1, 1, 1});
    file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    auto& material = file.json["materials"][0];
    material["pbrMetallicRoughness"]["metallicFactor"] = 1;
    material["extensions"]["BREWSTER_surface"] = {
        {"complexIor", {{"n", {0.2, 0.3, 0.4}}, {"k", {3, 2, 1}}}}, {"rmsHeight", 0.1}, {"correlationLength", 3}};
    file.json["extensionsUsed"] = {"BREWSTER_surface", "KHR_materials_specular"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"},
         {"extensions",
          {{"BREWSTER_surface",
            {{"angularDiameter", 0.5}, {"polarization", {{"dolp", 0.6}, {"aolp", 45}, {"docp", -0.8}}}}}}}}};
    file.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const Scene scene = read_scene_text(file.text(), "test");
    const Interface& interface = scene.materials[0].interface;
    expect_bands(interface.n, {0.2f, 0.3f, 0.4f}, 0.0f);
    expect_bands(interface.k, {3, 2, 1}, 0.0f);
    EXPECT_EQ(interface.finish, Finish::kirchhoff);
    ASSERT_EQ(scene.lamps.size(), 1u);
    expect_bands(scene.lamps[0].polarization, {0.0f, 0.6f, -0.8f}, 1e-6f);
    EXPECT_NEAR(scene.lamps[0].angular_radius, radians(0.25), 1e-7);
    expect_bands(scene.lamps[0].axis, {1, 0, 0}, 1e-6f);
}

}  // namespace
}  // namespace brewster
