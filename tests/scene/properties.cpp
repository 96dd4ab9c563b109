#include "scene/properties.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "base/error.h"
#include "scene/gltf_builder.h"
#include "scene/prepared_material.h"
#include "scene/test_materials.h"

namespace brewster {
namespace {

/// A room with a glowing ceiling, a sun, and one of each material that nobody wears.
Scene scene_of_all() {
    GltfBuilder builder;
    builder.add_material("wall", {0.5, 0.5, 0.5});
    builder.add_material("ceiling", {0, 0, 0}, 3);
    builder.add_box("room", {-1, -1, -1}, {1, 1, 1}, true, 0);
    builder.add_polygon("light", {{-0.5f, 0.9f, -0.5f}, {0.5f, 0.9f, -0.5f}, {0.5f, 0.9f, 0.5f}, {-0.5f, 0.9f, 0.5f}},
                        1);
    Scene scene = read_scene_text(builder.text(), "all");
    for (const Material& material : test_materials::all()) scene.materials.push_back(material);
    Material polarizer = test_materials::pane();
    polarizer.name = "polarizer";
    polarizer.interface = {};
    polarizer.filter.kind = FilterKind::polarizer;
    scene.materials.push_back(polarizer);
    Lamp sun;
    sun.kind = LampKind::sun;
    sun.name = "sun";
    sun.intensity = glm::vec3(1000.0f);
    scene.lamps.insert(scene.lamps.begin(), sun);
    set_lamp_property(scene, 0, *find_lamp_property("elevation"), 45.0);
    return scene;
}

std::uint32_t named(const Scene& scene, const std::string& name) {
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i)
        if (scene.materials[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
}

void set(Scene& scene, const std::string& material, const char* property, const PropertyValue& value) {
    set_property(scene, named(scene, material), *find_material_property(property), value);
}

TEST(Properties, EveryRowHasItsOwnNameAndARange) {
    std::set<std::string_view> names;
    for (const Property<Material>& row : material_properties()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(row.text.empty());
        EXPECT_EQ(row.change, Change::retrace);  // photons met the surface as it was
        EXPECT_TRUE(row.type == PropertyType::medium || row.least < row.most) << row.name;
        EXPECT_EQ(find_material_property(row.name), &row);
    }
    for (const Property<Lamp>& row : lamp_properties()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(find_lamp_property(row.name), &row);
    }
    EXPECT_EQ(find_material_property("rougness"), nullptr);
}

// What a slider shows can be set again and changes nothing, on every material and lamp, within rounding.
TEST(Properties, SettingWhatIsThereChangesNothing) {
    const Scene before = scene_of_all();
    for (std::uint32_t i = 0; i < before.materials.size(); ++i) {
        for (const Property<Material>& row : material_properties()) {
            if (!row.applies(before.materials[i])) continue;
            const PropertyValue value = row.get(before.materials[i]);
            if (row.type == PropertyType::medium && std::get<std::string>(value).empty()) continue;
            // Heights of a surface that has none as waves see them: 0 would make it smooth.
            if (row.name == "rmsHeight" && std::get<double>(value) == 0) continue;
            // A slope of its own would take the heights away.
            const bool waves = before.materials[i].interface.finish == Finish::kirchhoff;
            if (waves && (row.name == "roughness" || row.name == "m")) continue;
            Scene scene = before;
            set_property(scene, i, row, value);
            const Material &a = before.materials[i], &b = scene.materials[i];
            const std::string what = a.name + "." + std::string(row.name);
            EXPECT_EQ(a.base, b.base) << what;
            EXPECT_EQ(a.interface.kind, b.interface.kind) << what;
            EXPECT_EQ(a.interface.finish, b.interface.finish) << what;
            if (a.interface.present()) {
                EXPECT_LT(glm::length(a.interface.n - b.interface.n), 1e-6f) << what;
            }
            EXPECT_LT(glm::length(a.interface.k - b.interface.k), 1e-6f) << what;
            EXPECT_LT(glm::length(a.albedo - b.albedo) + glm::length(a.emission - b.emission), 1e-6f) << what;
            EXPECT_NEAR(a.interface.slope, b.interface.slope, 1e-6f) << what;
        }
    }
    for (const Property<Lamp>& row : lamp_properties()) {
        Scene scene = before;
        set_lamp_property(scene, 0, row, row.get(before.lamps[0]));
        EXPECT_LT(glm::length(scene.lamps[0].direction - before.lamps[0].direction), 1e-6f) << row.name;
        EXPECT_NEAR(scene.lamps[0].mean_power() / before.lamps[0].mean_power(), 1, 1e-6f) << row.name;
    }
}

// The lowest and the highest value of every row leave a material that light can meet.
TEST(Properties, EndsOfEveryRangeAreMaterials) {
    const Scene before = scene_of_all();
    const auto rules = std::make_shared<const OrderRules>();
    for (const char* name :
         {"Lambert", "smooth black", "rough gold", "Kirchhoff black", "glass", "pane", "polarizer"}) {
        const std::uint32_t i = named(before, name);
        for (const Property<Material>& row : material_properties()) {
            if (!row.applies(before.materials[i]) || row.type == PropertyType::medium) continue;
            for (const double end : {row.least, row.most}) {
                Scene scene = before;
                const PropertyValue value =
                    row.type == PropertyType::number ? PropertyValue(end) : PropertyValue(glm::dvec3(end));
                try {
                    set_property(scene, i, row, value);
                } catch (const Error&) {
                    continue;  // a slope too steep, said so
                }
                PreparedMaterial(scene.materials[i], rules);  // dies on a contradiction
            }
        }
    }
}

TEST(Properties, AnIndexMakesAnInterfaceAndTakesItAway) {
    Scene scene = scene_of_all();
    set(scene, "Lambert", "n", glm::dvec3(1.5));
    const Material& material = scene.materials[named(scene, "Lambert")];
    EXPECT_EQ(material.base, Base::polarized_diffuse);
    EXPECT_EQ(material.interface.kind, InterfaceKind::dielectric);
    EXPECT_EQ(material.albedo, glm::vec3(0.8f, 0.5f, 0.1f));
    set(scene, "Lambert", "roughness", 0.5);
    EXPECT_FLOAT_EQ(material.interface.slope, 0.25f);
    EXPECT_EQ(material.interface.finish, Finish::beckmann);
    set(scene, "Lambert", "n", glm::dvec3(1.0));
    EXPECT_EQ(material.base, Base::lambert);
    EXPECT_FALSE(material.interface.present());
    EXPECT_EQ(material.interface.finish, Finish::smooth);
}

TEST(Properties, MetalsByNameAndBack) {
    Scene scene = scene_of_all();
    set(scene, "plastic", "medium", std::string("gold"));
    const Material& material = scene.materials[named(scene, "plastic")];
    EXPECT_EQ(material.interface.kind, InterfaceKind::conductor);
    EXPECT_EQ(material.base, Base::black);
    EXPECT_FLOAT_EQ(material.interface.k.x, 3.215f);
    EXPECT_FLOAT_EQ(material.interface.slope, 0.15f);
    EXPECT_EQ(find_material_property("medium")->get(material), PropertyValue(std::string("gold")));
    set(scene, "plastic", "medium", std::string("glass"));
    EXPECT_EQ(material.interface.kind, InterfaceKind::dielectric);
}

TEST(Properties, HeightsOfWavesKeepTheSlopeAtFirst) {
    Scene scene = scene_of_all();
    set(scene, "plastic", "rmsHeight", 0.2);
    const Interface& interface = scene.materials[named(scene, "plastic")].interface;
    EXPECT_EQ(interface.finish, Finish::kirchhoff);
    EXPECT_NEAR(interface.slope, 0.15f, 1e-6f);
    EXPECT_NEAR(interface.correlation_length, 0.4f / 0.15f, 1e-5f);
    set(scene, "plastic", "correlationLength", 1.0);
    EXPECT_NEAR(interface.slope, 0.4f, 1e-6f);
    EXPECT_THROW(set(scene, "plastic", "correlationLength", 0.2), Error);
    EXPECT_NEAR(interface.slope, 0.4f, 1e-6f);
    set(scene, "plastic", "rmsHeight", 0.0);
    EXPECT_EQ(interface.finish, Finish::smooth);
}

TEST(Properties, GlowingSurfacesAreLamps) {
    Scene scene = scene_of_all();
    ASSERT_EQ(scene.lamps.size(), 2u);
    const float before = scene.lamps[1].mean_power();
    set(scene, "ceiling", "emission", glm::dvec3(6));
    ASSERT_EQ(scene.lamps.size(), 2u);
    EXPECT_NEAR(scene.lamps[1].mean_power(), 2 * before, 1e-4f * before);
    set(scene, "ceiling", "emission", glm::dvec3(0));
    EXPECT_EQ(scene.lamps.size(), 1u);
    set(scene, "wall", "emission", glm::dvec3(1));
    EXPECT_EQ(scene.lamps.size(), 7u);  // the sun and six walls
    EXPECT_EQ(scene.lamps[0].name, "sun");
}

TEST(Properties, TheSunGoesRound) {
    Scene scene = scene_of_all();
    const Lamp& sun = scene.lamps[0];
    set_lamp_property(scene, 0, *find_lamp_property("azimuth"), 90.0);
    set_lamp_property(scene, 0, *find_lamp_property("elevation"), 30.0);
    const float half = 0.5f, root = std::sqrt(0.75f);
    EXPECT_LT(glm::length(sun.direction - glm::vec3(-root, -half, 0)), 1e-6f);  // it stands at +x: light goes to -x
    // A box of side 2 under a sun at elevation e, side on: 2 (2 sin e + 2 cos e) m2.
    EXPECT_NEAR(sun.mean_power(), 1000 * 4 * (half + root), 1);
    set_lamp_property(scene, 0, *find_lamp_property("power"), 500.0);
    EXPECT_NEAR(sun.mean_power(), 500, 1e-2f);
    set_lamp_property(scene, 0, *find_lamp_property("dolp"), 0.6);
    set_lamp_property(scene, 0, *find_lamp_property("aolp"), 45.0);
    EXPECT_LT(glm::length(sun.polarization - glm::vec3(0, 0.6f, 0)), 1e-6f);
    EXPECT_THROW(set_lamp_property(scene, 0, *find_lamp_property("docp"), 0.9), Error);
}

TEST(Properties, WhatDoesNotFitIsSaid) {
    Scene scene = scene_of_all();
    EXPECT_THROW(set(scene, "Lambert", "roughness", 0.5), Error);  // nothing to be rough
    EXPECT_THROW(set(scene, "plastic", "roughness", 0.95), Error);
    EXPECT_THROW(set(scene, "plastic", "albedo", glm::dvec3(0.5, 1.1, 0.5)), Error);
    EXPECT_THROW(set(scene, "plastic", "angle", 3.0), Error);
    EXPECT_THROW(set(scene, "polarizer", "n", glm::dvec3(1.5)), Error);
    EXPECT_THROW(set_lamp_property(scene, 1, *find_lamp_property("power"), 1.0), Error);
    try {
        set(scene, "plastic", "m", 1.5);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "plastic: its m cannot be 1.5; choose 0 to 0.8");
    }
}

TEST(Properties, ValuesAreRead) {
    EXPECT_EQ(std::get<double>(parse_property(PropertyType::number, "0.25", "")), 0.25);
    EXPECT_EQ(std::get<glm::dvec3>(parse_property(PropertyType::bands, "1.5", "")), glm::dvec3(1.5));
    EXPECT_EQ(std::get<glm::dvec3>(parse_property(PropertyType::bands, "1,2,3", "")), glm::dvec3(1, 2, 3));
    EXPECT_EQ(std::get<std::string>(parse_property(PropertyType::medium, "gold", "")), "gold");
    for (const char* wrong : {"", "1,2", "1,2,3,4", "x", "1,", "nan", "1 2 3", "inf"}) {
        EXPECT_THROW(parse_property(PropertyType::bands, wrong, "wall.albedo"), Error) << wrong;
    }
    EXPECT_THROW(parse_property(PropertyType::number, "1,2,3", ""), Error);
    EXPECT_THROW(parse_property(PropertyType::direction, "0,0,0", ""), Error);
    EXPECT_THROW(parse_property(PropertyType::medium, "butter", ""), Error);
    EXPECT_EQ(property_text(glm::dvec3(0.1, 2, 1e9)), "0.1,2,1e+09");
}

}  // namespace
}  // namespace brewster
