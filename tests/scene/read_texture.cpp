#include "scene/read_texture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/gtc/constants.hpp>

#include "base/error.h"
#include "scene/albedo.h"
#include "scene/encoded_picture.h"
#include "scene/gltf_builder.h"
#include "scene/opened.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;

std::array<std::uint8_t, 4> quarters(int x, int y) {
    return {static_cast<std::uint8_t>(x == 0 ? 255 : 0), static_cast<std::uint8_t>(y == 0 ? 255 : 0), 128, 255};
}

// A unit square whose corners are those of the texture; v runs down as y runs up.
GltfBuilder textured_square(const std::vector<glm::vec2>& places = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}) {
    GltfBuilder file;
    file.add_material("paint", {0.5, 0.5, 0.5});
    file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        file.add_accessor(bytes_of(places), "VEC2", 5126, 4);
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = {{{"magFilter", 9728}}};
    return file;
}

GltfBuilder with_picture_in_view(GltfBuilder file, const std::string& bytes) {
    const int view = file.add_view(bytes);
    file.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    return file;
}

// Albedo at a place of the square.
glm::vec3 albedo(const Scene& scene, float x, float y) {
    const Rays rays(scene);
    const Ray ray{glm::vec3(glm::dvec3(x, y, 1) - scene.centre), {0, 0, -1}, no_triangle};
    Hit hit;
    rays.intersect({&ray, 1}, {&hit, 1});
    EXPECT_FALSE(hit.escaped());
    return albedo_at(scene, hit);
}

void expect_quarters(const Scene& scene) {
    const float blue = 0.5f * linear_of_srgb(128);
    for (const float x : {0.2f, 0.8f})
        for (const float y : {0.2f, 0.8f}) {
            const glm::vec3 found = albedo(scene, x, y);
            EXPECT_NEAR(found.x, x < 0.5f ? 0.5f : 0.0f, 1e-6);
            EXPECT_NEAR(found.y, y > 0.5f ? 0.5f : 0.0f, 1e-6);  // the first row is on top
            EXPECT_NEAR(found.z, blue, 1e-6);
        }
}

TEST(ReadTexture, PicturesInViewsAndDataUris) {
    const std::string png = png_bytes(2, 2, quarters);
    const Scene in_view = scene_of(with_picture_in_view(textured_square(), png));
    EXPECT_TRUE(in_view.warnings.empty()) << in_view.warnings[0];
    expect_quarters(in_view);
    GltfBuilder in_uri = textured_square();
    in_uri.json["images"] = {{{"uri", "data:image/png;base64," + base64(png)}}};
    expect_quarters(scene_of(in_uri));
    expect_quarters(read_scene_text(with_picture_in_view(textured_square(), png).glb(), "test"));
}

TEST(ReadTexture, JpegPictures) {
    const auto plain = [](int, int) { return std::array<std::uint8_t, 4>{180, 90, 40, 255}; };
    const Scene scene = scene_of(with_picture_in_view(textured_square(), jpeg_bytes(16, 16, plain)));
    const glm::vec3 found = albedo(scene, 0.4f, 0.6f);
    EXPECT_NEAR(found.x, 0.5f * linear_of_srgb(180), 0.01);
    EXPECT_NEAR(found.y, 0.5f * linear_of_srgb(90), 0.01);
    EXPECT_NEAR(found.z, 0.5f * linear_of_srgb(40), 0.01);
}

TEST(ReadTexture, PicturesBesideTheFile) {
    const fs::path folder = fs::temp_directory_path() / ("brewster texture " + std::to_string(getpid()));
    fs::create_directories(folder / "my pictures");
    std::ofstream(folder / "my pictures" / "a b.png", std::ios::binary) << png_bytes(2, 2, quarters);
    GltfBuilder file = textured_square();
    const auto read = [&](const std::string& uri) {
        file.json["images"] = {{{"uri", uri}}};
        std::ofstream(folder / "s.gltf", std::ios::binary) << file.text();
        return read_scene((folder / "s.gltf").string());
    };
    expect_quarters(read("my%20pictures/a%20b.png"));
    const Scene without = read("gone.png");
    EXPECT_TRUE(warns_of(without, "the picture \"gone.png\" is missing; the colours beside it are used alone"));
    EXPECT_NEAR(albedo(without, 0.5f, 0.5f).x, 0.5, 1e-6);
    std::ofstream(folder.parent_path() / "outside.png", std::ios::binary) << png_bytes(2, 2, quarters);
    EXPECT_THROW(read("../outside.png"), Error);
    fs::remove(folder.parent_path() / "outside.png");
    fs::remove_all(folder);
}

TEST(ReadTexture, BrokenPicturesAreSaidOnce) {
    GltfBuilder file = with_picture_in_view(textured_square(), "this is no picture");
    file.json["materials"].push_back(file.json["materials"][0]);
    file.json["materials"][1]["name"] = "other";
    const Scene scene = scene_of(file);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0],
              "the picture images[0] is no PNG or JPEG that can be read; the colours beside it are used alone");
}

TEST(ReadTexture, HugePicturesEndInWords) {
    // A header of 20000 x 2 pixels: refused before anything is unpacked.
    std::string png = png_bytes(2, 2, quarters);
    png.replace(16, 4, std::string("\x00\x00\x4e\x20", 4));
    try {
        scene_of(with_picture_in_view(textured_square(), png));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "test: the picture images[0] has 20000 x 2 pixels; scale it to at most 8192 a side");
    }
    GltfBuilder many = textured_square();
    std::string large = png_bytes(2, 2, quarters);
    large.replace(16, 8, std::string("\x00\x00\x20\x00\x00\x00\x20\x00", 8));  // 8192 x 8192
    const int view = many.add_view(large);
    many.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}},
                           {{"bufferView", view}, {"mimeType", "image/png"}}};
    many.json["textures"].push_back({{"source", 1}});
    many.json["materials"].push_back(many.json["materials"][0]);
    many.json["materials"][1]["name"] = "other";
    many.json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 1;
    try {
        scene_of(many);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("more than 64 million pixels together"), std::string::npos);
    }
}

// KHR_texture_transform as Blender's exporter and the Khronos sample models mean it: v grows downwards, and a turn by
// 90 degrees takes (u, v) to (v, -u).
TEST(ReadTexture, TransformsOfCoordinates) {
    GltfTextureUse use;
    use.scale = {2, 3};
    use.offset = {0.25, 0.5};
    EXPECT_EQ(transformed(use, {0.5f, 0.5f}), glm::vec2(1.25f, 2.0f));
    use.rotation = glm::half_pi<double>();
    const glm::vec2 turned = transformed(use, {0.5f, 0.25f});
    EXPECT_NEAR(turned.x, 0.25 + 0.75, 1e-6);
    EXPECT_NEAR(turned.y, 0.5 - 1.0, 1e-6);
}

TEST(ReadTexture, TransformAndSetOfATextureUse) {
    GltfBuilder file =
        with_picture_in_view(textured_square(std::vector<glm::vec2>(4, {0.9f, 0.9f})), png_bytes(2, 2, quarters));
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = file.add_accessor(
        bytes_of(std::vector<std::uint8_t>{0, 255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0}), "VEC2", 5121, 4);
    file.json["accessors"].back()["normalized"] = true;
    file.json["bufferViews"].back()["byteStride"] = 4;
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_texture_transform"};
    auto& use = file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    use["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}, {"offset", {0.5, 0}}};
    const Scene scene = scene_of(file);
    EXPECT_NEAR(albedo(scene, 0.2f, 0.8f).x, 0.0, 1e-6);  // moved by half a picture
    EXPECT_NEAR(albedo(scene, 0.8f, 0.8f).x, 0.5, 1e-6);
    use["texCoord"] = 1;
    use.erase("extensions");
    expect_quarters(scene_of(file));
    use["texCoord"] = 2;
    EXPECT_TRUE(warns_of(scene_of(file), "it has no coordinates for its texture; the first texel colours all of it"));
}

TEST(ReadTexture, VertexColoursOfEveryType) {
    const auto file_with = [](const std::string& bytes, const std::string& type, int component, int stride) {
        GltfBuilder file;
        file.add_material("paint", {0.5, 0.5, 0.5});
        file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
        file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = file.add_accessor(bytes, type, component, 4);
        file.json["bufferViews"].back()["byteStride"] = stride;
        file.json["accessors"].back()["normalized"] = component != 5126;
        return scene_of(file);
    };
    // Red falls along x: 1 1 0 .. at the corners (0, 0), (1, 0), (1, 1), (0, 1).
    const auto colours = [](auto one) {
        using Number = decltype(one);
        return bytes_of(std::vector<Number>{one, one, 0, one, 0, one, 0, one, 0, one, 0, one, one, one, 0, one});
    };
    for (const Scene& scene :
         {file_with(colours(1.0f), "VEC4", 5126, 16), file_with(colours(std::uint8_t{255}), "VEC4", 5121, 4),
          file_with(colours(std::uint16_t{65535}), "VEC4", 5123, 8), file_with(colours(1.0f), "VEC3", 5126, 16),
          file_with(colours(std::uint8_t{255}), "VEC3", 5121, 4)}) {
        EXPECT_TRUE(scene.warnings.empty());
        const glm::vec3 found = albedo(scene, 0.25f, 0.6f);
        EXPECT_NEAR(found.x, 0.5f * 0.75f, 1e-5);  // linear: no decoding
        EXPECT_NEAR(found.y, 0.5f, 1e-5);
        EXPECT_NEAR(found.z, 0.0f, 1e-5);
    }
}

TEST(ReadTexture, MeansStandForOtherTextures) {
    const auto halves = [](int x, int) {
        return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(x == 0 ? 255 : 0), 102, 51, 255};
    };
    GltfBuilder file = with_picture_in_view(textured_square(), png_bytes(2, 2, halves));
    auto& material = file.json["materials"][0];
    material["extensions"].erase("KHR_materials_specular");
    material["pbrMetallicRoughness"].erase("baseColorTexture");
    material["pbrMetallicRoughness"]["metallicFactor"] = 1;
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    material["emissiveTexture"] = {{"index", 0}};
    material["emissiveFactor"] = {1, 1, 1};
    material["normalTexture"] = {{"index", 0}, {"scale", 0.5}};
    material["occlusionTexture"] = {{"index", 0}};
    const Scene scene = scene_of(file);
    EXPECT_NEAR(scene.materials[0].interface.slope, 0.4f * 0.4f, 1e-5);       // (1 x 102/255)^2
    EXPECT_EQ(scene.materials[0].interface.kind, InterfaceKind::dielectric);  // metal 51/255 is none
    EXPECT_NEAR(scene.materials[0].emission.x, 0.5, 1e-6);
    EXPECT_NEAR(scene.lamps[0].intensity.y, linear_of_srgb(102), 1e-6);
    for (const char* words : {"material \"paint\": its metallicRoughnessTexture is not simulated; its mean is",
                              "material \"paint\": its emissiveTexture is not simulated; it glows evenly with the mean",
                              "material \"paint\": its normalTexture is not simulated; it is smooth",
                              "material \"paint\": its occlusionTexture is not needed"})
        EXPECT_TRUE(warns_of(scene, words)) << words;
}

TEST(ReadTexture, MeansStandForTexturesOfExtensions) {
    const auto halves = [](int x, int) {
        return std::array<std::uint8_t, 4>{static_cast<std::uint8_t>(x == 0 ? 255 : 204), 102, 51, 153};
    };
    GltfBuilder file = with_picture_in_view(textured_square(), png_bytes(2, 2, halves));
    auto& material = file.json["materials"][0];
    material["pbrMetallicRoughness"].erase("baseColorTexture");
    material["pbrMetallicRoughness"]["roughnessFactor"] = 0;
    material["extensions"]["KHR_materials_specular"] = {{"specularTexture", {{"index", 0}}}};
    EXPECT_NEAR(normal_reflectance(scene_of(file).materials[0].interface).x, 0.04f * 0.6f, 1e-6);
    EXPECT_TRUE(warns_of(scene_of(file), "material \"paint\": its specularTexture is not simulated; its mean is"));
    material["extensions"]["KHR_materials_specular"] = {{"specularColorTexture", {{"index", 0}}}};
    EXPECT_NEAR(normal_reflectance(scene_of(file).materials[0].interface).y, 0.04 * linear_of_srgb(102), 1e-5);
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1},
                                                            {"transmissionTexture", {{"index", 0}}}};
    material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 1}, {"thicknessTexture", {{"index", 0}}}};
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.materials[0].base, Base::transparent);  // 0.9
    EXPECT_FALSE(scene.materials[0].thin);
    EXPECT_TRUE(warns_of(scene, "material \"paint\": its transmissionTexture is not simulated; its mean is"));
    EXPECT_TRUE(warns_of(scene, "material \"paint\": it lets light pass entirely, not in part"));
}

// A metal has one index: its texture's mean makes it.
TEST(ReadTexture, MetalsTakeTheMean) {
    GltfBuilder file = with_picture_in_view(textured_square(), png_bytes(2, 2, quarters));
    file.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 1;
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.8, 0.8, 0.8, 1};
    file.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.2;
    const Scene scene = scene_of(file);
    EXPECT_EQ(scene.materials[0].texture, no_texture);
    EXPECT_NEAR(normal_reflectance(scene.materials[0].interface).x, 0.4, 1e-4);
    EXPECT_TRUE(warns_of(scene, "its baseColorTexture is not simulated on a metal; its mean is"));
}

}  // namespace
}  // namespace brewster
