#include "scene/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "base/units.h"
#include "bins/lookup.h"
#include "scene/gltf_builder.h"

namespace brewster {
namespace {

// Charts of outlines in the plane, turned and moved anywhere: the answers must not depend on it.
struct Outline {
    std::vector<glm::dvec2> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

Scene placed(const Outline& outline, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    const glm::dvec3 x = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(normal(engine), normal(engine), normal(engine)), x));
    const glm::dvec3 shift(normal(engine), normal(engine), normal(engine));
    Part part{"node", "mesh", 0, {}, {}, outline.triangles};
    for (const glm::dvec2 p : outline.points) part.vertices.emplace_back(p.x * x + p.y * y + shift);
    Scene scene;
    scene.materials.emplace_back();
    EXPECT_EQ(add_surfaces(scene, part), 0u);
    return scene;
}

void expect_one_chart(const Outline& outline, double area, double length, double width) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Scene scene = placed(outline, seed);
        ASSERT_EQ(scene.charts.size(), 1u);
        const Chart& chart = scene.charts[0];
        EXPECT_NEAR(chart.area, area, 1e-6 * area);
        EXPECT_NEAR(std::max(chart.size_u, chart.size_v), length, 1e-5 * length);
        EXPECT_NEAR(std::min(chart.size_u, chart.size_v), width, 1e-5 * length);
        EXPECT_NEAR(glm::dot(glm::cross(chart.axis_u, chart.axis_v), chart.normal), 1, 1e-6);
        EXPECT_EQ(chart.triangle_count, outline.triangles.size());
        for (const glm::vec3& p : scene.vertices) {
            const glm::vec2 uv = chart.unit_coordinates(p);
            EXPECT_GT(std::min(uv.x, uv.y), -3e-6f);
            EXPECT_LT(std::max(uv.x, uv.y), 1 + 3e-6f);
            const glm::vec3 back =
                chart.origin + uv.x * chart.size_u * chart.axis_u + uv.y * chart.size_v * chart.axis_v;
            EXPECT_NEAR(glm::distance(back, p), 0, 1e-5 * length);
        }
    }
}

TEST(Surfaces, Rectangle) {
    const Outline outline{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{0, 1, 2}, {0, 2, 3}}};
    expect_one_chart(outline, 12, 4, 3);
    // Its corners are corners of (u, v): edges along u and v.
    const Scene scene = placed(outline, 5);
    for (const glm::vec3& p : scene.vertices) {
        const glm::vec2 uv = scene.charts[0].unit_coordinates(p);
        EXPECT_NEAR(std::abs(uv.x - 0.5f), 0.5f, 3e-6f);
        EXPECT_NEAR(std::abs(uv.y - 0.5f), 0.5f, 3e-6f);
    }
}

TEST(Surfaces, Triangle) {
    expect_one_chart({{{0, 0}, {4, 0}, {0, 3}}, {{0, 1, 2}}}, 6, 5, 2.4);
}

// A 2 x 2 square without its upper right quarter; vertex 3 ends within the long edge 1-2 of no triangle: a T-junction.
TEST(Surfaces, LShapeWithTJunction) {
    expect_one_chart(
        {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}, {{0, 1, 2}, {0, 2, 6}, {6, 3, 4}, {6, 4, 5}}}, 3, 2,
        2);
}

TEST(Surfaces, Annulus) {
    Outline outline;
    constexpr std::uint32_t sides = 64;
    for (std::uint32_t k = 0; k < sides; ++k) {
        const double angle = 2 * pi * k / sides;
        outline.points.emplace_back(std::cos(angle), std::sin(angle));
        outline.points.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
    }
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t outer = 2 * k, inner = outer + 1, next = 2 * ((k + 1) % sides);
        outline.triangles.push_back({inner, outer, next});
        outline.triangles.push_back({inner, next, next + 1});
    }
    // A regular 64-gon: area n/2 sin(2 pi/n); its smallest rectangle touches opposite sides, 2 cos(pi/n) apart.
    const double area = 0.75 * sides / 2 * std::sin(2 * pi / sides);
    expect_one_chart(outline, area, 2 * std::cos(pi / sides), 2 * std::cos(pi / sides));
}

TEST(Surfaces, WallWithAWindow) {
    expect_one_chart({{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}},
                      {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}},
                     11, 4, 3);
}

TEST(Surfaces, TrianglesOfASurfaceStandTogether) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_box("box", {0, 0, 0}, {1, 2, 3}, false);
    const Scene scene = read_scene_text(file.text(), "test");
    ASSERT_EQ(scene.charts.size(), 6u);
    double area = 0;
    for (std::uint32_t c = 0; c < 6; ++c) {
        const Chart& chart = scene.charts[c];
        area += chart.area;
        for (std::uint32_t t = 0; t < chart.triangle_count; ++t) {
            EXPECT_EQ(scene.triangles[chart.first_triangle + t].surface, chart.surface);
            EXPECT_EQ(scene.triangles[chart.first_triangle + t].front_chart, c);
        }
        const glm::vec3 middle = chart.origin + 0.5f * (chart.size_u * chart.axis_u + chart.size_v * chart.axis_v);
        EXPECT_GT(glm::dot(middle, chart.normal), 0);  // outwards
    }
    EXPECT_NEAR(area, 22, 1e-6);
}

// Pulled points keep their distance from every edge: a millionth of the size, or a third of the height.
TEST(Surfaces, PointsAreHeldInsideTheirTriangle) {
    const Outline outline{{{0, 0}, {4, 0}, {0, 3}, {0, 3 + 1e-6}}, {{0, 1, 2}, {2, 1, 3}}};
    const Scene scene = placed(outline, 7);
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 p[3] = {glm::dvec3(scene.vertices[triangle.vertices[0]]),
                                 glm::dvec3(scene.vertices[triangle.vertices[1]]),
                                 glm::dvec3(scene.vertices[triangle.vertices[2]])};
        const double area2 = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
        for (const auto& [b1, b2] : {std::pair{0.0f, 0.0f},
                                     {1.0f, 0.0f},
                                     {0.0f, 1.0f},
                                     {0.5f, 0.5f},
                                     {0.3f, 0.0f},
                                     {0.0f, 0.6f},
                                     {-1e-6f, 0.4f},
                                     {0.7f, 0.3000002f}}) {
            const glm::dvec3 inside(scene.point_inside(triangle, b1, b2));
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 a = p[(k + 1) % 3], b = p[(k + 2) % 3];
                const double height = area2 / glm::length(b - a);
                const double distance = glm::dot(glm::cross(b - a, inside - a), glm::cross(p[1] - p[0], p[2] - p[0])) /
                                        (area2 * glm::length(b - a));
                // Half: the rounding of a float coordinate of 4 m is 2.4e-7 m.
                if (height < 1e-4) continue;
                EXPECT_GT(distance, 0.5 * 5e-6) << k << " " << b1 << " " << b2;
            }
        }
        const glm::dvec3 middle(scene.point_inside(triangle, 1 / 3.0f, 1 / 3.0f));
        EXPECT_NEAR(glm::distance(middle, (p[0] + p[1] + p[2]) / 3.0), 0, 1e-6);
    }
}

TEST(Chart, FixedPointIsThatOfTheLookup) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> unit(-0.1f, 1.1f);
    for (int i = 0; i < 100000; ++i) {
        const float x = unit(engine);
        ASSERT_EQ(chart_fixed_point(x), lookup::fixed_point_of(x)) << x;
    }
    for (const float x : {0.0f, 1.0f, 0.99999994f, 0.5f, 1e-8f, 5.9604645e-8f, -1.0f, 2.0f})
        EXPECT_EQ(chart_fixed_point(x), lookup::fixed_point_of(x)) << x;
    EXPECT_EQ(chart_fixed_point(1.0f), 0xffffffu);
}

}  // namespace
}  // namespace brewster
