#include "scene/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/gltf_builder.h"

namespace brewster {
namespace {

GltfBuilder floor_10_by_10() {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("floor", {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
    return file;
}

// Contacts of the floor in metres, each from its smaller end, sorted.
std::vector<std::array<float, 4>> on_floor(const GltfBuilder& file) {
    const Scene scene = read_scene_text(file.text(), "test");
    const std::uint32_t floor = scene.charts_of("floor")[0];
    const Chart& chart = scene.charts[floor];
    const auto in_file = [&](glm::vec2 uv) {
        const glm::vec3 p = chart.origin + uv.x * chart.size_u * chart.axis_u + uv.y * chart.size_v * chart.axis_v;
        return glm::vec2(p) + glm::vec2(scene.centre);
    };
    std::vector<std::array<float, 4>> lines;
    for (const Contact& contact : scene.contacts[floor]) {
        const glm::vec2 a = in_file(contact.from), b = in_file(contact.to);
        lines.push_back(a.x < b.x - 1e-4f || (a.x < b.x + 1e-4f && a.y < b.y) ? std::array{a.x, a.y, b.x, b.y}
                                                                              : std::array{b.x, b.y, a.x, a.y});
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

void expect_lines(const std::vector<std::array<float, 4>>& lines, std::vector<std::array<float, 4>> expected) {
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(lines.size(), expected.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(lines[i][k], expected[i][k], 2e-4f) << i << " " << k;
}

TEST(Contacts, OfAWallThatCrosses) {
    GltfBuilder file = floor_10_by_10();
    file.add_polygon("wall", {{4, 2, -1}, {4, 7, -1}, {4, 7, 3}, {4, 2, 3}});  // two triangles, one line
    expect_lines(on_floor(file), {{4, 2, 4, 7}});
}

TEST(Contacts, OfAWallThatTouches) {
    GltfBuilder file = floor_10_by_10();
    file.add_polygon("wall", {{1, 1, 0}, {6, 6, 0}, {6, 6, 3}, {1, 1, 3}});
    expect_lines(on_floor(file), {{1, 1, 6, 6}});
}

TEST(Contacts, OfABoxThatStands) {
    GltfBuilder file = floor_10_by_10();
    file.add_box("box", {2, 3, 0}, {4, 6, 5}, false);
    expect_lines(on_floor(file), {{2, 3, 4, 3}, {2, 6, 4, 6}, {2, 3, 2, 6}, {4, 3, 4, 6}});
}

TEST(Contacts, OfACoplanarPatchAreItsOutline) {
    GltfBuilder file = floor_10_by_10();
    file.add_polygon("rug", {{2, 2, 0}, {5, 2, 0}, {5, 4, 0}, {2, 4, 0}});
    expect_lines(on_floor(file), {{2, 2, 5, 2}, {2, 4, 5, 4}, {2, 2, 2, 4}, {5, 2, 5, 4}});
}

TEST(Contacts, AreCutAtTheRectangleAndNotOnItsBorder) {
    GltfBuilder file = floor_10_by_10();
    file.add_polygon("long wall", {{-5, 5, 0}, {15, 5, 0}, {15, 5, 3}, {-5, 5, 3}});
    file.add_polygon("border wall", {{0, 0, 0}, {10, 0, 0}, {10, 0, 3}, {0, 0, 3}});
    file.add_polygon("far wall", {{20, 0, 0}, {20, 10, 0}, {20, 10, 3}, {20, 0, 3}});
    file.add_polygon("above", {{3, 3, 0.01f}, {3, 6, 0.01f}, {3, 6, 3}, {3, 3, 3}});
    expect_lines(on_floor(file), {{0, 5, 10, 5}});
}

TEST(Contacts, OfABackAreThoseOfItsFront) {
    GltfBuilder file = floor_10_by_10();
    file.json["materials"][0]["doubleSided"] = true;
    file.add_polygon("wall", {{4, 2, -1}, {4, 7, -1}, {4, 7, 3}, {4, 2, 3}});
    const Scene scene = read_scene_text(file.text(), "test");
    const auto sides = scene.charts_of("floor");
    ASSERT_EQ(sides.size(), 2u);
    for (const std::uint32_t side : sides) {
        const Chart& chart = scene.charts[side];
        ASSERT_EQ(scene.contacts[side].size(), 1u);
        const glm::vec2 uv = scene.contacts[side][0].from;
        const glm::vec3 p = chart.origin + uv.x * chart.size_u * chart.axis_u + uv.y * chart.size_v * chart.axis_v;
        EXPECT_NEAR(p.x + scene.centre.x, 4, 1e-4);
    }
}

}  // namespace
}  // namespace brewster
