#include "scene/merged_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

namespace brewster {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// A lattice of unit squares, two triangles each, where `is_there` says so; turned and moved anywhere.
struct Lattice {
    std::vector<glm::vec2> flat;
    std::vector<glm::vec3> vertices;
    std::vector<Corners> triangles;

    Lattice(
        std::uint32_t width, std::uint32_t height, std::uint64_t seed,
        const std::function<bool(std::uint32_t, std::uint32_t)>& is_there = [](auto, auto) { return true; }) {
        std::mt19937_64 engine(seed);
        std::normal_distribution<double> normal;
        const glm::dvec3 x = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(normal(engine), normal(engine), normal(engine)), x));
        for (std::uint32_t j = 0; j <= height; ++j)
            for (std::uint32_t i = 0; i <= width; ++i) {
                flat.emplace_back(i, j);
                vertices.emplace_back(static_cast<double>(i) * x + static_cast<double>(j) * y + glm::dvec3(1, 2, 3));
            }
        for (std::uint32_t j = 0; j < height; ++j)
            for (std::uint32_t i = 0; i < width; ++i) {
                if (!is_there(i, j)) continue;
                const std::uint32_t a = j * (width + 1) + i, up = a + width + 1;
                triangles.push_back({a, a + 1, up + 1});
                triangles.push_back({a, up + 1, up});
            }
    }

    std::vector<Corners> merged(const VertexLook& look = {}) const {
        const std::vector<PlaneGroup> planes = plane_groups(vertices, triangles);
        EXPECT_EQ(planes.size(), 1u);
        return merged_triangles(vertices, look, triangles, planes[0], 5e-6);
    }

    double doubled_area(const Corners& t) const {
        const glm::dvec2 u = flat[t[1]] - flat[t[0]], v = flat[t[2]] - flat[t[0]];
        return u.x * v.y - u.y * v.x;
    }
    // How many triangles lie over a point.
    int covering(const std::vector<Corners>& all, glm::dvec2 p) const {
        return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Corners& t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec2 a = flat[t[k]], b = flat[t[(k + 1) % 3]];
                if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
            }
            return true;
        }));
    }
};

// Each point of the lattice is covered once, as before, and nothing else is.
void expect_same_cover(const Lattice& lattice, const std::vector<Corners>& merged, std::uint32_t width,
                       std::uint32_t height) {
    for (const Corners& t : merged) EXPECT_GT(lattice.doubled_area(t), 0);
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> u(-0.5, width + 0.5), v(-0.5, height + 0.5);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 p(u(engine), v(engine));
        ASSERT_EQ(lattice.covering(merged, p), lattice.covering(lattice.triangles, p)) << p.x << " " << p.y;
    }
}

TEST(MergedTriangles, ALatticeIsTwo) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Lattice lattice(9, 5, seed);
        const std::vector<Corners> merged = lattice.merged();
        ASSERT_EQ(merged.size(), 2u);
        expect_same_cover(lattice, merged, 9, 5);
    }
}

TEST(MergedTriangles, OutlinesKeepTheirCornersAndHoles) {
    struct Case {
        std::function<bool(std::uint32_t, std::uint32_t)> is_there;
        std::size_t triangles;  // corners + 2 holes - 2 of each piece
    };
    const std::vector<Case> cases = {
        {[](auto i, auto j) { return i < 3 || j < 2; }, 4},                         // an L
        {[](auto i, auto j) { return i < 2 || i > 5 || j < 2; }, 6},                // a U
        {[](auto i, auto j) { return i != 4 || j != 3; }, 8},                       // a window
        {[](auto i, auto j) { return (i != 2 && i != 6) || j < 2 || j > 4; }, 14},  // two
        {[](auto i, auto j) { return (i % 3 != 1) || (j != 1 && j != 4); }, 38},    // six
        {[](auto i, auto j) { return i != 4 && (i != 2 || j != 3); }, 8 + 2},       // two pieces, one with a window
        // The nearest corner to the upper window is that of a notch below the slit.
        {[](auto i, auto j) { return (i != 4 || (j != 0 && j != 4)) && (i < 1 || i > 7 || j != 2); }, 18},
        {[](auto i, auto j) { return i > 0 && i < 8 && j > 0 && (j < 6 || i == 4); }, 6},  // a T
    };
    for (const Case& each : cases) {
        const Lattice lattice(9, 7, 3, each.is_there);
        const std::vector<Corners> merged = lattice.merged();
        EXPECT_EQ(merged.size(), each.triangles);
        expect_same_cover(lattice, merged, 9, 7);
    }
}

// What meets itself in a corner, overlaps or is too ragged stays.
TEST(MergedTriangles, OthersStay) {
    const Lattice chess(4, 4, 1, [](auto i, auto j) { return (i + j) % 2 == 0; });
    EXPECT_EQ(chess.merged().size(), chess.triangles.size());  // each square is a piece of two
    const Lattice pinched(4, 4, 1, [](auto i, auto j) { return !(i == 1 && j == 1) && !(i == 2 && j == 2); });
    EXPECT_EQ(pinched.merged(), pinched.triangles);
    const Lattice comb(80, 2, 1, [](auto i, auto j) { return j == 0 || i % 2 == 0; });
    EXPECT_EQ(comb.merged(), comb.triangles);
    Lattice twice(4, 4, 1);
    twice.triangles.push_back(twice.triangles[5]);
    EXPECT_EQ(twice.merged(), twice.triangles);
}

TEST(MergedTriangles, WhatVerticesCarryIsKept) {
    const Lattice lattice(6, 4, 2);
    const std::size_t count = lattice.vertices.size();
    std::vector<glm::vec3> normals(count, glm::normalize(glm::vec3(1, 2, 3)));
    std::vector<glm::vec2> coordinates;
    std::vector<glm::vec4> colors;
    for (const glm::vec2& p : lattice.flat) {
        coordinates.emplace_back(0.3f + 0.25f * p.x - 0.1f * p.y, 0.2f * p.x + 0.5f * p.y);
        colors.emplace_back(p.x / 6, p.y / 4, 0.5f, 1.0f);
    }
    EXPECT_EQ(lattice.merged({normals, coordinates, colors}).size(), 2u);

    // One vertex in the middle that says something else.
    const std::size_t middle = 2 * 7 + 3;
    std::vector<glm::vec3> bent = normals;
    bent[middle] = glm::normalize(glm::vec3(1, 2, 3.01f));
    EXPECT_EQ(lattice.merged({bent, coordinates, colors}), lattice.triangles);
    std::vector<glm::vec2> shifted = coordinates;
    shifted[middle].x += 1e-3f;
    EXPECT_EQ(lattice.merged({normals, shifted, colors}), lattice.triangles);
    std::vector<glm::vec4> spotted = colors;
    spotted[middle].z = 0.49f;
    EXPECT_EQ(lattice.merged({normals, coordinates, spotted}), lattice.triangles);
}

// Squares with vertices of their own are joined where these stand at one place; a tile's own texture keeps them apart.
TEST(MergedTriangles, PlacesCountAndNotNumbers) {
    const Lattice lattice(4, 3, 4);
    Lattice apart = lattice;
    apart.vertices.clear();
    apart.flat.clear();
    apart.triangles.clear();
    std::vector<glm::vec2> tiled;
    for (std::size_t t = 0; t < lattice.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = lattice.triangles[t][k];
            apart.vertices.push_back(lattice.vertices[vertex]);
            apart.flat.push_back(lattice.flat[vertex]);
            tiled.emplace_back(k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f);
        }
        const auto first = static_cast<std::uint32_t>(3 * t);
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    EXPECT_EQ(apart.merged().size(), 2u);
    EXPECT_EQ(apart.merged({{}, tiled, {}}), apart.triangles);
}

}  // namespace
}  // namespace brewster
