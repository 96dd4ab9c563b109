#include "scene/walls.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/philox.h"
#include "scene/lamp.h"
#include "scene/passed_by.h"
#include "scene/ray_tree.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

std::vector<std::uint32_t> all_triangles(const Scene& scene) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) all.push_back(t);
    return all;
}

// Inside the scene in all directions, a third of them from surfaces.
std::vector<Ray> some_rays(const Scene& scene, std::uint64_t count) {
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto words = philox(3, i, 0, 0);
        Ray ray;
        ray.origin = 0.3f * scene.radius() * sample_sphere(unit_float(words[0]), unit_float(words[1]));
        ray.direction = sample_sphere(unit_float(words[2]), unit_float(words[3]));
        if (i % 3 == 0) {
            ray.leaving = words[0] % static_cast<std::uint32_t>(scene.triangles.size());
            ray.origin = scene.point_inside(scene.triangles[ray.leaving], 0.45f * unit_float(words[1]),
                                            0.45f * unit_float(words[2]));
            ray.direction = sample_sphere(unit_float(words[3]), unit_float(words[2] * 2654435761u));
        }
        rays.push_back(ray);
    }
    return rays;
}

std::vector<TriangleHit> by_walls(const Walls& walls, const PassedBy& passed_by, const std::vector<Ray>& rays) {
    std::vector<TriangleHit> hits(rays.size());
    std::vector<std::uint32_t> planes;
    for (const Ray& ray : rays) planes.push_back(passed_by.plane_left(ray.leaving));
    walls.trace(rays, planes.data(), hits.data());
    return hits;
}

// Every triangle of these rooms is in a wall, and the rectangles are one each.
TEST(Walls, RectanglesAreOneWall) {
    const auto scene = rooms::read("furnace.gltf");
    const PassedBy passed_by(*scene);
    const Walls walls(*scene, passed_by.planes());
    EXPECT_EQ(walls.count(), 6u);
    EXPECT_TRUE(walls.others().empty());
}

// Each of the triangles cut in four, so many times.
void cut_in_four(Scene& scene, std::vector<Triangle> triangles, int times) {
    for (; times > 0; --times) {
        std::vector<Triangle> finer;
        for (const Triangle& whole : triangles) {
            const auto& v = whole.vertices;
            const auto first = static_cast<std::uint32_t>(scene.vertices.size());
            for (std::size_t i = 0; i < 3; ++i)
                scene.vertices.push_back(0.5f * (scene.vertices[v[i]] + scene.vertices[v[(i + 1) % 3]]));
            const std::uint32_t a = first, b = first + 1, c = first + 2;
            for (const auto& corners : {std::array{v[0], a, c}, {a, v[1], b}, {c, b, v[2]}, {a, b, c}}) {
                finer.push_back(whole);
                finer.back().vertices = corners;
            }
        }
        triangles = std::move(finer);
    }
    scene.triangles.insert(scene.triangles.end(), triangles.begin(), triangles.end());
}

// A furnace of 12 triangles, all of them or the last one in small pieces.
TEST(Walls, OfManyOnlyLargeOnesAreAskedOneByOne) {
    const auto walls_of = [](std::size_t kept, int times) {
        Scene scene = *rooms::read("furnace.gltf");
        const std::vector<Triangle> rest(scene.triangles.begin() + static_cast<std::ptrdiff_t>(kept),
                                         scene.triangles.end());
        scene.triangles.resize(kept);
        cut_in_four(scene, rest, times);
        const PassedBy passed_by(scene);
        const Walls walls(scene, passed_by.planes());
        EXPECT_EQ(walls.count() == 0, walls.others().size() == scene.triangles.size());
        return walls.count();
    };
    EXPECT_GE(walls_of(0, 2), 96u);  // 192 triangles, some of them in pairs
    EXPECT_LE(walls_of(0, 2), 192u);
    EXPECT_EQ(walls_of(0, 4), 0u);
    EXPECT_EQ(walls_of(11, 5), 6u);
}

// Walls and tree find the same triangles at the same places, to rounding. Only where a ray meets an edge, which of rays
// in all directions one in ten thousand does within a few millionths, may they choose different ones.
TEST(Walls, AgreeWithTheTree) {
    for (const char* name : {"cornell-box.gltf", "gloss-lab.gltf", "brewster-room.gltf", "metal-lab.gltf"}) {
        const auto scene = rooms::read(name);
        const PassedBy passed_by(*scene);
        const Walls walls(*scene, passed_by.planes());
        ASSERT_TRUE(walls.others().empty()) << name;
        const RayTree tree(*scene, passed_by, all_triangles(*scene));
        const std::vector<Ray> rays = some_rays(*scene, 30000);
        const std::vector<TriangleHit> flat = by_walls(walls, passed_by, rays);
        std::vector<TriangleHit> climbed(rays.size());
        for (TriangleHit& hit : climbed) hit.distance = INFINITY;
        tree.improve(rays, climbed);
        int different = 0, met = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (flat[i].triangle != climbed[i].triangle) {
                ++different;
                continue;
            }
            if (!flat[i].met()) continue;
            ++met;
            const float tolerance = 1e-5f * (scene->radius() + flat[i].distance);
            EXPECT_NEAR(flat[i].distance, climbed[i].distance, 10 * tolerance) << name << i;
            const Triangle& triangle = scene->triangles[flat[i].triangle];
            EXPECT_LT(glm::distance(scene->point_inside(triangle, flat[i].b1, flat[i].b2),
                                    scene->point_inside(triangle, climbed[i].b1, climbed[i].b2)),
                      10 * tolerance)
                << name << i;
        }
        EXPECT_GT(met, 10000) << name;
        EXPECT_LE(different, 10) << name;
    }
}

// A ray alone, and one among any others.
TEST(Walls, AnswersDoNotDependOnCompany) {
    const auto scene = rooms::read("metal-lab.gltf");
    const PassedBy passed_by(*scene);
    const Walls walls(*scene, passed_by.planes());
    const std::vector<Ray> rays = some_rays(*scene, 1000);
    const std::vector<TriangleHit> together = by_walls(walls, passed_by, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const TriangleHit alone = by_walls(walls, passed_by, {rays[i]})[0];
        EXPECT_EQ(alone.triangle, together[i].triangle);
        EXPECT_EQ(alone.distance, together[i].distance);
        EXPECT_EQ(alone.b1, together[i].b1);
        EXPECT_EQ(alone.b2, together[i].b2);
    }
}

}  // namespace
}  // namespace brewster
