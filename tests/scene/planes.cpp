#include "scene/planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace brewster {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct Mesh {
    std::vector<glm::vec3> vertices;
    Triangles triangles;

    void add_quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const glm::vec3 p : {a, b, c, d}) vertices.push_back(p);
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
    }

    std::vector<PlaneGroup> groups() const { return plane_groups(vertices, triangles); }
};

// A unit square at height z, turned about the y axis by an angle.
void add_square(Mesh& mesh, float x, float z, double angle = 0) {
    const auto dx = static_cast<float>(std::cos(angle)), dz = static_cast<float>(std::sin(angle));
    mesh.add_quad({x, 0, z}, {x + dx, 0, z + dz}, {x + dx, 1, z + dz}, {x, 1, z});
}

TEST(Planes, JoinWhatLiesInOnePlaneConnectedOrNot) {
    Mesh mesh;
    add_square(mesh, 0, 0);
    add_square(mesh, 5, 0);
    add_square(mesh, 0, 1);
    add_square(mesh, -7, 0);
    const auto groups = mesh.groups();
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].triangles, (std::vector<std::uint32_t>{0, 1, 2, 3, 6, 7}));
    EXPECT_EQ(groups[1].triangles, (std::vector<std::uint32_t>{4, 5}));
    EXPECT_NEAR(groups[1].offset, 1, 1e-12);
    EXPECT_NEAR(groups[0].normal.z, 1, 1e-12);
}

TEST(Planes, KeepOppositeSidesApart) {
    Mesh mesh;
    add_square(mesh, 0, 0);
    mesh.add_quad({0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0});
    EXPECT_EQ(mesh.groups().size(), 2u);
}

// Two unit squares 2 m apart: the group is 3 m long, so heights up to 3e-5 m (its diagonal 3.2e-5) join.
TEST(Planes, JoinWithinTheToleranceOfDistance) {
    for (const auto& [height, count] : {std::pair{2.5e-5f, 1u}, {-2.5e-5f, 1u}, {4e-5f, 2u}, {-4e-5f, 2u}}) {
        Mesh mesh;
        add_square(mesh, 0, 0);
        add_square(mesh, 2, height);
        EXPECT_EQ(mesh.groups().size(), count) << height;
    }
}

// Small squares, so that tilting moves corners less than the tolerance of distance.
TEST(Planes, JoinWithinTheToleranceOfAngle) {
    for (const auto& [degrees, count] : {std::pair{0.05, 1u}, {0.3, 2u}}) {
        Mesh mesh;
        mesh.add_quad({-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0});
        add_square(mesh, 0, 0, degrees * 3.14159265 / 180);
        for (int k = 4; k < 8; ++k) mesh.vertices[static_cast<std::size_t>(k)] *= 0.2f;
        EXPECT_EQ(mesh.groups().size(), count) << degrees;
    }
}

TEST(Planes, CurvedMeshesFallIntoFacets) {
    Mesh mesh;
    constexpr int sides = 360;
    const auto rim = [](int k, float z) {
        const double angle = 2 * 3.14159265358979 * k / sides;
        return glm::vec3(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), z);
    };
    for (int k = 0; k < sides; ++k) mesh.add_quad(rim(k, 0), rim(k + 1, 0), rim(k + 1, 3), rim(k, 3));
    EXPECT_EQ(mesh.groups().size(), static_cast<std::size_t>(sides));
}

// Every triangle is in exactly one group and near its plane, whatever the orientation; no two groups could be one.
TEST(Planes, PartitionRandomlyTurnedBoxes) {
    std::mt19937 engine(3);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec3 x = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(normal(engine), normal(engine), normal(engine))));
        const glm::dvec3 z = glm::cross(x, y);
        Mesh mesh;
        const auto at = [&](double a, double b, double c) { return glm::vec3(a * x + b * y + c * z); };
        for (int k = 0; k < 5; ++k) {  // five storeys: five parallel planes, each of four tiles
            for (int tile = 0; tile < 4; ++tile) {
                const double a = tile % 2 * 2.0, b = tile / 2 * 2.0;
                mesh.add_quad(at(a, b, k), at(a + 1, b, k), at(a + 1, b + 1, k), at(a, b + 1, k));
            }
        }
        const auto groups = mesh.groups();
        ASSERT_EQ(groups.size(), 5u);
        std::vector<int> uses(mesh.triangles.size());
        for (const PlaneGroup& group : groups)
            for (const std::uint32_t t : group.triangles) {
                ++uses[t];
                for (const std::uint32_t vertex : mesh.triangles[t])
                    EXPECT_NEAR(glm::dot(group.normal, glm::dvec3(mesh.vertices[vertex])), group.offset, 1e-6);
            }
        EXPECT_EQ(std::count(uses.begin(), uses.end(), 1), static_cast<std::ptrdiff_t>(uses.size()));
    }
}

// 4e5 facets of a bumpy terrain, 1e5 parallel blinds: seconds would mean a quadratic search.
TEST(Planes, StayNearLinear) {
    Mesh terrain, blinds;
    const auto bump = [](int i, int j) {
        return glm::vec3(static_cast<float>(i), static_cast<float>(j),
                         static_cast<float>(3 * std::sin(0.37 * i) * std::cos(0.23 * j)));
    };
    for (int i = 0; i < 450; ++i)
        for (int j = 0; j < 450; ++j) terrain.add_quad(bump(i, j), bump(i + 1, j), bump(i + 1, j + 1), bump(i, j + 1));
    for (int k = 0; k < 50000; ++k) add_square(blinds, 0, static_cast<float>(k) * 0.01f);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_GT(terrain.groups().size(), 300000u);
    EXPECT_EQ(blinds.groups().size(), 50000u);
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 60);
}

}  // namespace
}  // namespace brewster
