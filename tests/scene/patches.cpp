#include "scene/patches.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "scene/curved_parts.h"

namespace brewster {
namespace {

Scene scene_of(const Part& part) {
    Scene scene;
    scene.materials.emplace_back();
    add_surfaces(scene, part);
    return scene;
}

Part flat(Part part) {
    part.normals.clear();
    return part;
}

std::size_t curved_charts(const Scene& scene) {
    std::size_t count = 0;
    for (const Chart& chart : scene.charts) count += chart.curved;
    return count;
}

void expect_sound(const Scene& scene) {
    const double least = std::cos(radians(widest_cone)) - 1e-5;
    double area = 0, charts = 0;
    for (const Triangle& triangle : scene.triangles) {
        const Chart& chart = scene.charts[triangle.front_chart];
        EXPECT_GT(glm::dot(glm::dvec3(scene.facet_normal(triangle)), glm::dvec3(chart.normal)), least);
        const glm::dvec3 a(scene.vertices[triangle.vertices[0]]), b(scene.vertices[triangle.vertices[1]]),
            c(scene.vertices[triangle.vertices[2]]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
        for (const std::uint32_t vertex : triangle.vertices) {
            const glm::vec2 uv = chart.unit_coordinates(scene.vertices[vertex]);
            EXPECT_GT(std::min(uv.x, uv.y), -1e-5f);
            EXPECT_LT(std::max(uv.x, uv.y), 1 + 1e-5f);
        }
    }
    for (const Chart& chart : scene.charts) charts += chart.area;
    EXPECT_NEAR(charts, area, 1e-9 * area);
}

// The number of charts follows the curvature, not the number of triangles.
TEST(Patches, SphereHasSixAtAnyResolution) {
    for (const std::uint32_t rows : {8u, 32u, 128u}) {
        for (const double sign : {1.0, -1.0}) {
            const Scene scene = scene_of(sphere_part(rows, 1, sign));
            EXPECT_EQ(scene.charts.size(), 6u) << rows;
            EXPECT_EQ(curved_charts(scene), 6u) << rows;
            expect_sound(scene);
        }
    }
}

TEST(Patches, SaddleIsOneTorusFew) {
    const Scene saddle = scene_of(saddle_part(16));
    EXPECT_EQ(saddle.charts.size(), 1u);
    expect_sound(saddle);
    const Scene torus = scene_of(torus_part(48, 1, 0.4));
    EXPECT_LE(torus.charts.size(), 12u);
    EXPECT_EQ(curved_charts(torus), torus.charts.size());
    expect_sound(torus);
}

// Facets are meant as they are, unless there are so many that they approximate something curved.
TEST(Patches, FacetsWithoutNormals) {
    const Scene few = scene_of(flat(sphere_part(12, 1, 1)));
    EXPECT_EQ(curved_charts(few), 0u);
    EXPECT_GT(few.charts.size(), 200u);
    const Scene many = scene_of(flat(sphere_part(64, 1, 1)));
    EXPECT_EQ(many.charts.size(), 6u);
    EXPECT_EQ(curved_charts(many), 6u);
}

// Normals that jump at an edge keep its sides apart.
TEST(Patches, CreasesStaySharp) {
    Part part = saddle_part(16);
    Part other = part;
    for (glm::vec3& n : other.normals) n = glm::normalize(n + glm::vec3(0.3f, 0, 0));
    for (glm::vec3& p : other.vertices) p.x += 1;  // beside the first; their border is not smooth
    const auto first = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.insert(part.vertices.end(), other.vertices.begin(), other.vertices.end());
    part.normals.insert(part.normals.end(), other.normals.begin(), other.normals.end());
    for (const auto& [a, b, c] : other.triangles) part.triangles.push_back({first + a, first + b, first + c});
    EXPECT_EQ(scene_of(part).charts.size(), 2u);
}

// Two turns of a spiral ramp look up everywhere, but lie over each other.
TEST(Patches, SpiralRampDoesNotFold) {
    constexpr double rise = 0.1;
    const Scene scene = scene_of(curved_part(
        64, 2,
        [](double s, double t) {
            const double turn = 4 * pi * s;
            return glm::dvec3((0.5 + t) * std::sin(turn), (0.5 + t) * std::cos(turn), rise * turn);
        },
        [](double s, double t) {
            const double turn = 4 * pi * s;
            return glm::normalize(glm::dvec3(-rise * std::cos(turn), rise * std::sin(turn), 0.5 + t));
        }));
    expect_sound(scene);
    ASSERT_GE(scene.charts.size(), 2u);
    for (const Chart& chart : scene.charts) {
        double projected = 0;
        for (std::uint32_t k = 0; k < chart.triangle_count; ++k) {
            const Triangle& t = scene.triangles[chart.first_triangle + k];
            const glm::vec3 a = scene.vertices[t.vertices[0]];
            projected += 0.5 * static_cast<double>(glm::dot(
                                   glm::cross(scene.vertices[t.vertices[1]] - a, scene.vertices[t.vertices[2]] - a),
                                   chart.normal));
        }
        EXPECT_LT(projected, pi * (1.5 * 1.5 - 0.5 * 0.5));
    }
}

}  // namespace
}  // namespace brewster
