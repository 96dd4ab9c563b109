#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <map>

#include "base/error.h"
#include "base/units.h"
#include "scene/gltf_builder.h"
#include "scene/opened.h"
#include "scene/scene.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;

// A unit square in the plane z = 0 that faces +z, with one grey material.
GltfBuilder square() {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    return file;
}

glm::vec3 in_file(const Scene& scene, glm::vec3 p) {
    return glm::vec3(glm::dvec3(p) + scene.centre);
}

void expect_vector(glm::vec3 a, glm::vec3 b, float tolerance = 1e-6f) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

struct Expected {
    std::size_t charts, lamps, cameras;
};

TEST(Read, CanonicalScenesOpen) {
    const std::map<std::string, Expected> scenes = {
        {"cornell-box", {16, 1, 3}}, {"furnace", {6, 6, 1}},    {"brewster-room", {11, 1, 3}},
        {"gloss-lab", {12, 1, 3}},   {"metal-lab", {12, 1, 2}}, {"spheres", {25, 1, 2}},
    };
    for (const auto& [name, expected] : scenes) {
        const Scene scene = read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/" + name + ".gltf");
        EXPECT_EQ(scene.name, name);
        EXPECT_EQ(scene.charts.size(), expected.charts) << name;
        EXPECT_EQ(scene.lamps.size(), expected.lamps) << name;
        EXPECT_EQ(scene.cameras.size(), expected.cameras) << name;
        EXPECT_TRUE(scene.warnings.empty()) << name << ": " << scene.warnings[0];
        expect_vector(scene.low, -scene.high, 1e-6f);
    }
}

TEST(Read, CornellBoxMaterialsAndLamp) {
    const Scene scene = read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/cornell-box.gltf");
    EXPECT_TRUE(scene.warnings.empty());
    const Lamp& lamp = scene.lamps[0];
    EXPECT_EQ(lamp.kind, LampKind::area);
    EXPECT_EQ(lamp.name, "lamp");
    expect_vector(lamp.intensity, {17.0f, 12.0f, 4.0f}, 1e-5f);  // 17 x (1, 12/17, 4/17)
    expect_vector(lamp.power, lamp.intensity * static_cast<float>(pi * 0.04), 1e-5f);
    const Chart& red = scene.charts[scene.charts_of("left")[0]];
    expect_vector(scene.materials[red.material].albedo, {0.63f, 0.065f, 0.05f});
    EXPECT_EQ(scene.triangles[red.first_triangle].back_chart, no_chart);
}

TEST(Read, TransformsNest) {
    GltfBuilder file = square();
    file.json["nodes"][0]["rotation"] = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};  // +90 degrees about x: y to z, z to -y
    file.json["nodes"][0]["scale"] = {2, 3, 1};
    file.json["nodes"][0]["translation"] = {10, 0, 0};
    file.json["scenes"][0]["nodes"] = nlohmann::json::array();
    file.add_node({{"name", "parent"},
                   {"children", {0}},
                   {"matrix", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 5, 1}}});  // x to -z, z to x, then +5 z
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.charts.size(), 1u);
    EXPECT_NEAR(scene.charts[0].area, 6, 1e-6);
    // The square: (x, y, 0) -> (2x + 10, 0, 3y) -> (3y, 0, -2x - 10 + 5).
    expect_vector(in_file(scene, scene.low), {0, 0, -7});
    expect_vector(in_file(scene, scene.high), {3, 0, -5});
    expect_vector(scene.charts[0].normal, {0, -1, 0});
}

// A mirrored node keeps its front: its triangles are turned, because mirroring turns their corners' sense.
TEST(Read, NegativeScaleFlipsTheWinding) {
    for (const nlohmann::json& scale : {nlohmann::json{-1, 1, 1}, nlohmann::json{1, -1, 1}, nlohmann::json{1, 1, 1}}) {
        GltfBuilder file = square();
        file.json["nodes"][0]["scale"] = scale;
        EXPECT_NEAR(scene_of(file).charts[0].normal.z, 1, 1e-6) << scale;
    }
    GltfBuilder through = square();
    through.json["nodes"][0]["scale"] = {1, 1, -1};
    EXPECT_NEAR(scene_of(through).charts[0].normal.z, -1, 1e-6);
}

TEST(Read, EveryIndexWidthAndNone) {
    for (const int type : {5121, 5123, 5125, 0}) {
        GltfBuilder file;
        file.add_material("grey", {0.5, 0.5, 0.5});
        file.add_mesh("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, 0, type);
        const Scene scene = scene_of(file);
        ASSERT_EQ(scene.charts.size(), 1u) << type;
        EXPECT_NEAR(scene.charts[0].area, 1, 1e-7) << type;
    }
}

TEST(Read, InterleavedVertices) {
    GltfBuilder file = square();
    // Views of 24 bytes a vertex: every second float triple of eight.
    file.add_mesh("wide", {{0, 0, 1}, {9, 9, 9}, {1, 0, 1}, {9, 9, 9}, {1, 1, 1}, {9, 9, 9}}, {{0, 1, 2}}, 0, 5125);
    auto& accessor = file.json["accessors"][2];
    accessor["count"] = 3;
    file.json["bufferViews"][2]["byteStride"] = 24;
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.charts.size(), 2u);
    EXPECT_NEAR(scene.charts[1].area, 0.5, 1e-7);
    EXPECT_NEAR(in_file(scene, scene.high).z, 1, 1e-6);
}

TEST(Read, SeveralPrimitivesAndMaterialsOfAMesh) {
    GltfBuilder file = square();
    file.add_material("red", {0.6, 0.1, 0.1});
    file.add_polygon("spare", {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}});
    file.add_polygon("third", {{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}}, 1);
    auto& primitives = file.json["meshes"][0]["primitives"];
    primitives.push_back(file.json["meshes"][1]["primitives"][0]);
    primitives.push_back(file.json["meshes"][2]["primitives"][0]);
    file.json["scenes"][0]["nodes"] = {0};
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.charts.size(), 2u);  // both grey primitives lie in one plane: one chart
    EXPECT_NEAR(scene.charts[0].area, 2, 1e-7);
    EXPECT_NEAR(scene.charts[1].area, 1, 1e-7);
    EXPECT_EQ(scene.materials[scene.charts[1].material].name, "red");
    EXPECT_EQ(scene.charts_of("square").size(), 2u);
}

TEST(Read, DoubleSidedMaterialsHaveTwoChartsOfOneSurface) {
    GltfBuilder file = square();
    file.json["materials"][0]["doubleSided"] = true;
    file.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.charts.size(), 2u);
    EXPECT_EQ(scene.charts[0].surface, scene.charts[1].surface);
    expect_vector(scene.charts[0].normal, -scene.charts[1].normal);
    for (const Chart& chart : scene.charts) expect_vector(glm::cross(chart.axis_u, chart.axis_v), chart.normal);
    EXPECT_EQ(scene.triangles[0].front_chart, 0u);
    EXPECT_EQ(scene.triangles[0].back_chart, 1u);
    ASSERT_EQ(scene.lamps.size(), 2u);  // it glows on both sides
    EXPECT_EQ(scene.lamps[1].chart, 1u);
}

TEST(Read, DefaultMaterialIsSaid) {
    GltfBuilder file = square();
    file.json["meshes"][0]["primitives"][0].erase("material");
    const Scene scene = scene_of(file);
    expect_vector(scene.materials[scene.charts[0].material].albedo, glm::vec3(0.8f));
    EXPECT_TRUE(warns_of(scene, "mesh \"square\": it has no material and gets Lambert of albedo 0.8"));
}

TEST(Read, WhatIsNotSimulatedIsSaid) {
    GltfBuilder file = square();
    file.json["extensionsUsed"] = {"KHR_materials_clearcoat", "EXT_of_nobody"};
    file.json["animations"] = {{{"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}}};
    auto& material = file.json["materials"][0];
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    material["extensions"].erase("KHR_materials_specular");
    material["alphaMode"] = "BLEND";
    file.add_material("gold", {1, 0.8, 0.3});
    file.json["materials"][1]["pbrMetallicRoughness"]["metallicFactor"] = 1;
    file.json["meshes"][0]["primitives"].push_back(file.json["meshes"][0]["primitives"][0]);
    file.json["meshes"][0]["primitives"][1]["mode"] = 1;
    file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    file.json["meshes"][0]["weights"] = {0.5};
    file.json["cameras"] = {
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 1}}}}};
    file.add_node({{"name", "flat"}, {"camera", 0}});
    const Scene scene = scene_of(file);
    for (const char* words :
         {"the extension KHR_materials_clearcoat is not read", "the extension EXT_of_nobody is not read",
          "animations are not played", "material \"grey\": its roughness is not simulated where light passes",
          "material \"grey\": its colour is not simulated where light passes",
          "material \"gold\": its roughness is taken as m = 0.8",
          "material \"grey\": its alpha mode BLEND is not simulated", "mesh \"square\": its morph targets are not read",
          "mesh \"square\": its points and lines are left out",
          "camera \"flat\": its type orthographic is not simulated"})
        EXPECT_TRUE(warns_of(scene, words)) << words;
    EXPECT_EQ(scene.warnings.size(), 10u);
    EXPECT_EQ(scene.cameras[0].name, "fit");
}

TEST(Read, NamesStayOnOneLine) {
    GltfBuilder file = square();
    file.json["nodes"][0]["name"] = "a\nb";
    file.json["materials"][0]["name"] = std::string("c\0d", 3);
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.charts[0].mesh, "a b");
    EXPECT_EQ(scene.materials[0].name, "c d");
}

// What Blender writes for a ball of glass has no thickness, and so is a bubble; a flat pane is what it seems.
TEST(Read, CurvedPanesAreSaidToBeShells) {
    GltfBuilder file;
    file.add_material("glass", {1, 1, 1});
    file.json["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    file.json["materials"][0]["extensions"].erase("KHR_materials_specular");
    file.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0;
    file.add_mesh("roof", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2}, {0, 1, 0.2}, {1, 2, 0}, {0, 2, 0}},
                  {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}});
    const char* words = "material \"glass\": it is a thin shell, not a body";
    EXPECT_FALSE(warns_of(scene_of(file), words));
    file.add_attribute(0, "NORMAL", {{0, -0.2f, 1}, {0, -0.2f, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0.2f, 1}, {0, 0.2f, 1}});
    EXPECT_TRUE(warns_of(scene_of(file), words));
    file.json["materials"][0]["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 1}};
    EXPECT_FALSE(warns_of(scene_of(file), words));
}

// Nothing to say of morph targets that are all at rest, nor of one scene.
TEST(Read, WhatNeedsNoWordGetsNone) {
    GltfBuilder file = square();
    file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    file.json["meshes"][0]["weights"] = {0};
    EXPECT_TRUE(scene_of(file).warnings.empty());
}

TEST(Read, TheDefaultSceneOfSeveral) {
    GltfBuilder file = square();
    file.add_polygon("far", {{0, 0, 5}, {3, 0, 5}, {3, 1, 5}, {0, 1, 5}});
    file.json["scenes"] = {{{"nodes", {0}}}, {{"name", "other"}, {"nodes", {1}}}};
    file.json["scene"] = 1;
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.charts.size(), 1u);
    EXPECT_EQ(scene.charts[0].mesh, "far");
    EXPECT_TRUE(warns_of(scene, "it holds 2 scenes; \"other\" is shown"));
    file.json.erase("scene");
    EXPECT_EQ(scene_of(file).charts[0].mesh, "square");
    EXPECT_TRUE(warns_of(scene_of(file), "it holds 2 scenes; scene 0 is shown"));
}

TEST(Read, MaterialsOfOneNameAreToldApart) {
    GltfBuilder file = square();
    file.add_material("grey", {0.1, 0.1, 0.1});
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.materials[1].name, "grey 2");
    EXPECT_TRUE(warns_of(scene, "material \"grey\" is there twice; the second is called \"grey 2\""));
}

TEST(Read, UnlitMaterialsAreLambert) {
    GltfBuilder file = square();
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_materials_unlit"};
    file.json["materials"][0]["extensions"] = {{"KHR_materials_unlit", nlohmann::json::object()}};
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.materials[0].base, Base::lambert);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(warns_of(scene, "material \"grey\": it is unlit in the file; it is a Lambert surface"));
}

// Two joints, one of them turned: each vertex stands where its joint puts it, whatever its own node says.
TEST(Read, SkinsStandAsTheirJointsDo) {
    GltfBuilder file = square();
    file.json["nodes"][0]["translation"] = {100, 100, 100};
    file.json["nodes"][0]["skin"] = 0;
    file.add_node({{"name", "still"}});
    file.add_node({{"name", "moved"}, {"translation", {0, 2, 0}}});
    // Joint 1 was bound one up: its inverse bind matrix moves one down.
    const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
    const int bind = file.add_accessor(bytes_of(matrices), "MAT4", 5126, 2);
    file.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}}};
    const std::vector<std::uint8_t> joints = {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0};
    auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = file.add_accessor(bytes_of(joints), "VEC4", 5121, 4);
    attributes["WEIGHTS_0"] = file.add_accessor(bytes_of(weights), "VEC4", 5126, 4);
    const Scene scene = scene_of(file);
    // (0, 0), (1, 0), (1, 1 + 1), (0, 1 + 1/2): a trapezium.
    ASSERT_EQ(scene.charts.size(), 1u);
    EXPECT_NEAR(scene.charts[0].area, 1.75, 1e-6);
    expect_vector(in_file(scene, scene.high), {1, 2, 0});
    EXPECT_TRUE(warns_of(scene, "mesh \"square\": its skin is not animated; it stands as its joints do in the file"));
}

TEST(Read, TrianglesWithoutAreaAreCounted) {
    GltfBuilder file = square();
    file.add_mesh("thin", {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 0, 1}, {0, 1, 3}});
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.triangles.size(), 3u);
    EXPECT_TRUE(warns_of(scene, "2 triangles without area are left out"));
}

TEST(Read, CamerasAnswerToNodeAndOwnName) {
    GltfBuilder file = square();
    file.json["cameras"] = {
        {{"name", "Camera.main"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 0.1}}}},
        {{"name", "shared"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.2}}}},
        {{"name", "shared"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.6}, {"znear", 0.2}}}}};
    file.add_node({{"name", "front"}, {"camera", 0}, {"translation", {0, 0, 4}}, {"scale", {2, 2, 2}}});
    file.add_node({{"name", "a"}, {"camera", 1}});
    file.add_node({{"name", "a"}, {"camera", 2}});
    const Scene scene = scene_of(file);
    EXPECT_FLOAT_EQ(scene.camera("front").vertical_field_of_view, 0.9f);
    EXPECT_EQ(&scene.camera("Camera.main"), &scene.camera("front"));
    expect_vector(in_file(scene, scene.camera("front").position), {0, 0, 4});
    expect_vector(scene.camera("front").forward, {0, 0, -1});
    expect_vector(scene.camera("front").up, {0, 1, 0});
    EXPECT_FLOAT_EQ(scene.camera("a").vertical_field_of_view, 0.7f);
    EXPECT_FLOAT_EQ(scene.camera("a 2").vertical_field_of_view, 0.6f);
    EXPECT_TRUE(warns_of(scene, "the second is called \"a 2\""));
    try {
        scene.camera("shared");  // two cameras have it
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "test: it has no camera \"shared\"; choose one of \"front\", \"a\", \"a 2\"");
    }
}

TEST(Read, MeshesAnswerToNodeAndOwnName) {
    GltfBuilder file = square();
    EXPECT_EQ(scene_of(file).charts_of("square mesh"), std::vector<std::uint32_t>{0});
    file.add_node({{"name", "twin"}, {"mesh", 0}, {"translation", {0, 0, 1}}});
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.charts_of("twin"), std::vector<std::uint32_t>{1});
    EXPECT_THROW(scene.charts_of("square mesh"), Error);
}

TEST(Read, FitHoldsTheSceneWithoutCameras) {
    const Scene scene = scene_of(square());
    ASSERT_EQ(scene.cameras.size(), 1u);
    const Camera& fit = scene.cameras[0];
    EXPECT_EQ(fit.name, "fit");
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p(corner & 1 ? scene.high.x : scene.low.x, corner & 2 ? scene.high.y : scene.low.y,
                          corner & 4 ? scene.high.z : scene.low.z);
        const glm::vec4 clip = view_projection(fit, 100, 100, 0, 0, 100) * glm::vec4(p, 1);
        EXPECT_LT(std::abs(clip.x), clip.w);
        EXPECT_LT(std::abs(clip.y), clip.w);
    }
}

TEST(Read, PunctualLights) {
    GltfBuilder file = square();
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensionsRequired"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 1000}, {"color", {1, 0.5, 0.25}}},
        {{"type", "point"}, {"name", "bulb"}, {"intensity", 100}, {"range", 5}},
        {{"type", "spot"}, {"intensity", 10}, {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.6}}}}};
    const auto light = [](int i) { return nlohmann::json{{"KHR_lights_punctual", {{"light", i}}}}; };
    file.add_node({{"name", "sun"}, {"extensions", light(0)}});
    file.add_node({{"extensions", light(1)}, {"translation", {0.5, 0.5, 2}}});
    file.add_node({{"extensions", light(2)}, {"rotation", {0, 1, 0, 0}}});
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.lamps.size(), 3u);
    EXPECT_EQ(scene.lamps[0].kind, LampKind::sun);
    expect_vector(scene.lamps[0].direction, {0, 0, -1});
    expect_vector(scene.lamps[0].power, {1000, 500, 250}, 1e-3f);  // 1 m2 of bounds across the beam
    EXPECT_EQ(scene.lamps[1].name, "bulb");
    expect_vector(in_file(scene, scene.lamps[1].position), {0.5, 0.5, 2});
    EXPECT_NEAR(scene.lamps[1].power.x, 400 * pi, 1e-3);
    EXPECT_TRUE(warns_of(scene, "light \"bulb\": its range is ignored"));
    EXPECT_EQ(scene.lamps[2].name, "light 2");
    expect_vector(scene.lamps[2].direction, {0, 0, 1});
    const double inner = std::cos(0.3), outer = std::cos(0.6);
    EXPECT_NEAR(scene.lamps[2].power.x, 20 * pi * ((1 - inner) + (inner - outer) / 3), 1e-5);
    EXPECT_NEAR(scene.total_power().x, 1000 + 400 * pi + scene.lamps[2].power.x, 1e-2);
}

// Positions of 1e5 m keep their tenths of millimetres, because the centre is taken off in double.
TEST(Read, RecentresInDouble) {
    GltfBuilder file = square();
    file.json["nodes"][0]["translation"] = {1e5, 0.1, -3e5};
    file.json["nodes"][0]["scale"] = {0.001, 0.001, 1};
    const Scene scene = scene_of(file);
    EXPECT_NEAR(scene.centre.x, 100000.0005, 1e-9);
    EXPECT_NEAR(scene.charts[0].area, 1e-6, 1e-12);
    EXPECT_NEAR(scene.high.x, 0.0005, 1e-9);
}

class OnDisk : public testing::Test {
  protected:
    OnDisk() : folder_(fs::temp_directory_path() / ("brewster read " + std::to_string(getpid()))) {
        fs::create_directories(folder_ / "inner");
    }
    ~OnDisk() override { fs::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return (folder_ / name).string();
    }

    // The square with its buffer in a file of that name.
    std::string square_with_buffer(const std::string& uri) const {
        nlohmann::json file = nlohmann::json::parse(square().text());
        file["buffers"][0]["uri"] = uri;
        return file.dump();
    }

    std::string buffer_bytes() const {
        const std::string glb = square().glb();
        return glb.substr(glb.size() - 72);
    }

    fs::path folder_;
};

TEST_F(OnDisk, BinaryFiles) {
    const Scene scene = read_scene(write("my square.glb", square().glb()));
    EXPECT_EQ(scene.name, "my square");
    EXPECT_NEAR(scene.charts[0].area, 1, 1e-7);
}

TEST_F(OnDisk, BuffersBesideTheFileAndBelow) {
    write("inner/a b.bin", buffer_bytes());
    EXPECT_NEAR(read_scene(write("s.gltf", square_with_buffer("inner/a%20b.bin"))).charts[0].area, 1, 1e-7);
}

TEST_F(OnDisk, BuffersOutsideTheFolderAreRefused) {
    write("secret.bin", buffer_bytes());
    const auto expect_refusal = [this](const std::string& uri) {
        try {
            read_scene(write("inner/s.gltf", square_with_buffer(uri)));
            ADD_FAILURE() << uri;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("not below its own folder"), std::string::npos) << error.what();
        }
    };
    expect_refusal("../secret.bin");
    expect_refusal("..%2Fsecret.bin");
    fs::create_symlink(folder_ / "secret.bin", folder_ / "inner/link.bin");
    expect_refusal("link.bin");
}

TEST_F(OnDisk, MissingFilesAreNamed) {
    const auto message = [](const std::string& path) -> std::string {
        try {
            read_scene(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message((folder_ / "none.gltf").string()).find("there is no such file"), std::string::npos);
    EXPECT_NE(message(folder_.string()).find("it is not a file"), std::string::npos);
    EXPECT_NE(
        message(write("s.gltf", square_with_buffer("gone.bin"))).find("the file \"gone.bin\" that it names is missing"),
        std::string::npos);
    EXPECT_NE(message(write("short.glb", square().glb().substr(0, 30))).find("header is broken"), std::string::npos);
    EXPECT_NE(message(write("empty.gltf", "")).find("it is empty"), std::string::npos);
}

}  // namespace
}  // namespace brewster
