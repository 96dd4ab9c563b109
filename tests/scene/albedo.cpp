#include "scene/albedo.h"

#include <gtest/gtest.h>

#include "scene/encoded_picture.h"
#include "scene/gltf_builder.h"

namespace brewster {
namespace {

// A unit square one metre above another; columns of the upper one's texture are holes by turns. `single`: the upper
// one looks down, so that rays from above meet its back.
Scene lattice(bool single_sided_back = false) {
    GltfBuilder file;
    file.add_material("ground", {0.5, 0.5, 0.5});
    file.add_material("lattice", {0.8, 0.8, 0.8});
    file.add_polygon("ground", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    std::vector<glm::vec3> outline = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    std::vector<glm::vec2> places = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    if (single_sided_back) {
        std::swap(outline[1], outline[3]);
        std::swap(places[1], places[3]);
    }
    file.add_polygon("lattice", outline, 1);
    file.json["meshes"][1]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        file.add_accessor(bytes_of(places), "VEC2", 5126, 4);
    const auto columns = [](int x, int) {
        return std::array<std::uint8_t, 4>{255, 255, 255, static_cast<std::uint8_t>(x % 2 == 0 ? 100 : 200)};
    };
    const int view = file.add_view(png_bytes(4, 1, columns));
    file.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = {{{"magFilter", 9728}}};
    auto& material = file.json["materials"][1];
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    material["alphaMode"] = "MASK";
    const Scene scene = read_scene_text(file.text(), "test");
    EXPECT_TRUE(scene.warnings.empty());
    return scene;
}

Hit hit_of(const Scene& scene, glm::vec3 origin, glm::vec3 direction, bool meets_holes, std::uint32_t leaving) {
    const Rays rays(scene);
    Ray ray{glm::vec3(glm::dvec3(origin) - scene.centre), direction, leaving};
    ray.meets_holes = meets_holes;
    Hit hit;
    rays.intersect({&ray, 1}, {&hit, 1});
    std::vector<Ray> eight(8, ray);
    std::vector<Hit> hits(8);
    rays.intersect(eight, hits);
    for (const Hit& each : hits) {
        EXPECT_EQ(each.triangle, hit.triangle);
        EXPECT_EQ(each.distance, hit.distance);
    }
    return hit;
}

TEST(Albedo, RaysPassThroughHoles) {
    const Scene scene = lattice();
    for (int column = 0; column < 4; ++column) {
        const float x = (static_cast<float>(column) + 0.5f) / 4;
        const bool hole = column % 2 == 0;
        const Hit through = hit_of(scene, {x, 0.4f, 2}, {0, 0, -1}, false, no_triangle);
        EXPECT_NEAR(through.distance, hole ? 2 : 1, 1e-5) << column;
        EXPECT_FALSE(through.hole);
        const Hit stopped = hit_of(scene, {x, 0.4f, 2}, {0, 0, -1}, true, no_triangle);
        EXPECT_NEAR(stopped.distance, 1, 1e-5);
        EXPECT_EQ(stopped.hole, hole);
        EXPECT_NE(stopped.chart, no_chart);
        // From below, and from the surface itself.
        EXPECT_EQ(hit_of(scene, {x, 0.4f, 0.5f}, {0, 0, 1}, false, no_triangle).escaped(), hole);
        EXPECT_NEAR(
            hit_of(scene, stopped.position + glm::vec3(scene.centre), {0, 0, -1}, true, stopped.triangle).distance, 1,
            1e-5);
    }
}

// A back that absorbs is cut out like a front.
TEST(Albedo, BacksHaveHolesToo) {
    const Scene scene = lattice(true);
    EXPECT_NEAR(hit_of(scene, {0.125f, 0.4f, 2}, {0, 0, -1}, false, no_triangle).distance, 2, 1e-5);
    EXPECT_NEAR(hit_of(scene, {0.375f, 0.4f, 2}, {0, 0, -1}, false, no_triangle).distance, 1, 1e-5);
    const Hit hole = hit_of(scene, {0.125f, 0.4f, 2}, {0, 0, -1}, true, no_triangle);
    EXPECT_TRUE(hole.hole);
    EXPECT_EQ(hole.chart, no_chart);
}

TEST(Albedo, CutoffAndFactorDecide) {
    Scene scene = lattice();
    const std::uint32_t triangle = 2;  // of the lattice
    Material& material = scene.materials[1];
    ASSERT_EQ(scene.charts[scene.triangles[triangle].front_chart].mesh, "lattice");
    const auto holes = [&] {
        int count = 0;
        for (int column = 0; column < 4; ++column) {
            const float x = (static_cast<float>(column) + 0.5f) / 4;
            // Corners (0, 0), (1, 0), (1, 1): b1 = x - y, b2 = y.
            count += is_hole(scene, triangle, 0.9f * x, 0.1f * x);
        }
        return count;
    };
    EXPECT_EQ(holes(), 2);
    material.alpha = 0.6f;  // 0.6 x 200/255 = 0.47
    EXPECT_EQ(holes(), 4);
    material.alpha_cutoff = 0.2f;
    EXPECT_EQ(holes(), 0);
    material.alpha_cutoff = 0;
    material.alpha = 0;
    EXPECT_EQ(holes(), 0);
}

}  // namespace
}  // namespace brewster
