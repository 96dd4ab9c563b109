#include "scene/read_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "scene/accessor.h"
#include "scene/gltf_builder.h"
#include "scene/gltf_parse.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace brewster {
namespace {

GltfFile parsed(const GltfBuilder& builder) {
    const std::string text = builder.text();
    const GltfFile file = parse_gltf({reinterpret_cast<const unsigned char*>(text.data()), text.size()}, {}, "test");
    validate(file, "test");
    return file;
}

PlacedPrimitive placed(const GltfBuilder& builder, const glm::dmat4& to_world = glm::dmat4(1.0)) {
    const GltfFile file = parsed(builder);
    return place_primitive(file, file.meshes[0].primitives[0], {to_world, {}}, 0);
}

// An octahedron about the origin with its corners' directions as normals.
GltfBuilder octahedron() {
    const std::vector<glm::vec3> corners = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_mesh("ball", corners,
                  {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}});
    file.add_attribute(0, "NORMAL", corners);
    return file;
}

// The octahedron becomes an ellipsoid; its normals are the gradient of its equation, mirrored or not.
TEST(ReadMesh, NormalsFollowTheInverseTranspose) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3));
    for (const glm::dvec3& scale : {glm::dvec3(1, 2, 3), glm::dvec3(-1, 2, 3), glm::dvec3(-2, -1, 4)}) {
        const glm::dmat4 shape =
            turn * glm::scale(glm::dmat4(1.0), scale) * glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0, 1, 1));
        const PlacedPrimitive part = placed(octahedron(), shape);
        ASSERT_EQ(part.normals.size(), part.vertices.size());
        const glm::dmat3 back = glm::inverse(glm::dmat3(shape));
        for (std::size_t i = 0; i < part.normals.size(); ++i) {
            const glm::dvec3 gradient = glm::transpose(back) * (back * part.vertices[i]);
            EXPECT_LT(glm::length(glm::dvec3(part.normals[i]) - glm::normalize(gradient)), 1e-6);
        }
        for (const auto& [a, b, c] : part.triangles) {  // fronts look outwards still
            const glm::dvec3 facet =
                glm::cross(part.vertices[b] - part.vertices[a], part.vertices[c] - part.vertices[a]);
            EXPECT_GT(glm::dot(facet, part.vertices[a] + part.vertices[b] + part.vertices[c]), 0);
        }
    }
}

TEST(ReadMesh, NormalsOfTheFacetsAreLeftOut) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    file.add_attribute(0, "NORMAL", std::vector<glm::vec3>(4, {0, 0, 1}));
    EXPECT_TRUE(placed(file).normals.empty());
    file.add_attribute(0, "NORMAL", {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0.02f, 1}});
    EXPECT_EQ(placed(file).normals.size(), 4u);
    file.add_attribute(0, "NORMAL", std::vector<glm::vec3>(4, {0, 0, -1}));  // against the front: not flat
    EXPECT_EQ(placed(file).normals.size(), 4u);
}

TEST(ReadMesh, NormalsWithoutLengthAreMendedAndSaid) {
    GltfBuilder file = octahedron();
    std::vector<glm::vec3> normals = {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    file.add_attribute(0, "NORMAL", normals);
    const PlacedPrimitive part = placed(file);
    EXPECT_EQ(part.mended_normals, 1u);
    for (std::size_t i = 0; i < part.vertices.size(); ++i)
        EXPECT_LT(glm::length(glm::dvec3(part.normals[i]) - part.vertices[i]), 1e-6);
    EXPECT_EQ(read_scene_text(file.text(), "test").warnings[0],
              "mesh \"ball\": 1 of its normals have no length; the mean of the facets around them stands in");
}

// A strip of a folded band and a fan of a hexagon, against the same triangles as a list.
TEST(ReadMesh, StripsAndFansAreLists) {
    const std::vector<std::array<std::size_t, 3>> strip = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
    const std::vector<std::array<std::size_t, 3>> fan = {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}};
    for (std::size_t t = 0; t < 4; ++t) {
        EXPECT_EQ(triangle_corners(gltf_triangle_strip, t), strip[t]);
        EXPECT_EQ(triangle_corners(gltf_triangle_fan, t), fan[t]);
    }
    const std::vector<glm::vec3> band = {{0, 0, 0}, {0, -1, 0}, {1, 0, 0}, {1, -1, 0}, {2, 0, 0}, {2, -1, 0}};
    const std::vector<glm::vec3> hexagon = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
    for (const int mode : {gltf_triangle_strip, gltf_triangle_fan}) {
        for (const int width : {5121, 5123, 5125, 0}) {
            GltfBuilder file;
            file.add_material("grey", {0.5, 0.5, 0.5});
            file.add_mesh("shape", mode == gltf_triangle_strip ? band : hexagon, {{0, 1, 2}, {3, 4, 5}}, 0, width);
            file.json["meshes"][0]["primitives"][0]["mode"] = mode;
            const Scene scene = read_scene_text(file.text(), "test");
            ASSERT_EQ(scene.charts.size(), 1u) << mode;
            EXPECT_EQ(scene.triangles.size(), mode == gltf_triangle_strip ? 2u : 4u);  // as few as the outline needs
            EXPECT_NEAR(scene.charts[0].area, mode == gltf_triangle_strip ? 2 : 12, 1e-6);
            EXPECT_NEAR(scene.charts[0].normal.z, 1, 1e-6);
        }
    }
}

TEST(ReadMesh, QuantizedAndSparseVertices) {
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto file_with = [&](const std::string& bytes, int type, bool normalized) {
        GltfBuilder file;
        file.add_material("grey", {0.5, 0.5, 0.5});
        file.add_polygon("square", corners);
        file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
        const int accessor = file.add_accessor(bytes, "VEC3", type, 4);
        file.json["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = normalized;
        file.json["bufferViews"].back()["byteStride"] = type == 5120 || type == 5121 ? 4 : 8;
        file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = accessor;
        return file;
    };
    const auto padded = [](auto low, auto high) {
        using Number = decltype(low);
        return bytes_of(std::vector<Number>{low, low, 0, 0, high, low, 0, 0, high, high, 0, 0, low, high, 0, 0});
    };
    const auto area = [](const GltfBuilder& file) { return read_scene_text(file.text(), "test").charts[0].area; };
    EXPECT_NEAR(area(file_with(padded(std::uint8_t{0}, std::uint8_t{255}), 5121, true)), 1, 1e-6);
    EXPECT_NEAR(area(file_with(padded(std::uint8_t{5}, std::uint8_t{15}), 5121, false)), 100, 1e-4);
    EXPECT_NEAR(area(file_with(padded(std::int8_t{-128}, std::int8_t{127}), 5120, true)), 4, 1e-6);
    EXPECT_NEAR(area(file_with(padded(std::int16_t{-32767}, std::int16_t{32767}), 5122, true)), 4, 1e-6);
    EXPECT_NEAR(area(file_with(padded(std::uint16_t{0}, std::uint16_t{300}), 5123, false)), 90000, 0.1);
    EXPECT_TRUE(read_scene_text(file_with(padded(std::uint8_t{0}, std::uint8_t{255}), 5121, true).text(), "test")
                    .warnings.empty());

    // The last two corners move up by one; without a bufferView the first two are zeros.
    for (const bool with_view : {true, false}) {
        GltfBuilder file;
        file.add_material("grey", {0.5, 0.5, 0.5});
        file.add_polygon("square", corners);
        const int indices = file.add_view(bytes_of(std::vector<std::uint16_t>{1, 2, 3}));
        const int values = file.add_view(bytes_of(std::vector<glm::vec3>{{1, 0, 0}, {1, 2, 0}, {0, 2, 0}}));
        auto& accessor = file.json["accessors"][0];
        accessor["sparse"] = {{"count", 3},
                              {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                              {"values", {{"bufferView", values}}}};
        if (!with_view) accessor.erase("bufferView");
        EXPECT_NEAR(area(file), 2, 1e-6);
    }
}

// The spheres of the canonical scene arrive smooth: each normal points from its sphere's centre.
TEST(ReadMesh, CanonicalSpheresAreSmooth) {
    GltfFile file;
    {
        const std::string path = std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/spheres.gltf";
        std::vector<unsigned char> bytes;
        FILE* stream = std::fopen(path.c_str(), "rb");
        ASSERT_NE(stream, nullptr);
        for (int c; (c = std::fgetc(stream)) != EOF;) bytes.push_back(static_cast<unsigned char>(c));
        std::fclose(stream);
        file = parse_gltf(bytes, {}, path);
    }
    validate(file, "spheres");
    int spheres = 0;
    for (const GltfMesh& mesh : file.meshes) {
        const PlacedPrimitive part = place_primitive(file, mesh.primitives[0], {}, 0);
        if (mesh.name.rfind("sphere", 0) != 0) {
            EXPECT_TRUE(part.normals.empty()) << mesh.name;
            continue;
        }
        ++spheres;
        ASSERT_EQ(part.normals.size(), part.vertices.size()) << mesh.name;
        glm::dvec3 low = part.vertices[0], high = low;
        for (const glm::dvec3& p : part.vertices) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        for (std::size_t i = 0; i < part.vertices.size(); ++i) {
            const glm::dvec3 outward = glm::normalize(part.vertices[i] - 0.5 * (low + high));
            EXPECT_LT(glm::length(outward - glm::dvec3(part.normals[i])), 2e-3) << mesh.name;
        }
    }
    EXPECT_EQ(spheres, 3);
}

}  // namespace
}  // namespace brewster
