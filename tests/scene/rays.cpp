#include "scene/rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>

#include "base/philox.h"
#include "base/units.h"
#include "optics/random_light.h"
#include "scene/curved_parts.h"
#include "scene/exact_hit.h"
#include "scene/gltf_builder.h"
#include "scene/lamp.h"
#include "scene/opened.h"

namespace brewster {
namespace {

Hit hit_of(const Rays& rays, const Ray& ray) {
    Hit hit;
    rays.intersect({&ray, 1}, {&hit, 1});
    return hit;
}

bool same_bits(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && a.chart == b.chart && a.u == b.u && a.v == b.v &&
           std::memcmp(&a.distance, &b.distance, sizeof a.distance) == 0 &&
           std::memcmp(&a.position, &b.position, sizeof a.position) == 0;
}

// How often leaks are looked for; the full proof takes 1e8 (BREWSTER_LEAK_RAYS=1e8). None may be found, however few.
std::uint64_t leak_rays() {
    const char* wanted = std::getenv("BREWSTER_LEAK_RAYS");
    return wanted ? static_cast<std::uint64_t>(std::strtod(wanted, nullptr)) : 500000 / light_test_scale;
}

struct Leaks {
    std::uint64_t rays = 0, escaped = 0, behind = 0;
};

// Bounces light between the walls of a closed scene. Half of the bounces aim close along the surface (to the least
// cosine that 24-bit numbers give, 2.4e-4) or at one of the first eight vertices, the room's corners, where leaks are.
Leaks bounce(const Scene& scene, std::uint64_t count) {
    const Rays rays(scene);
    Leaks leaks;
    Ray ray;
    bool start = true;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto words = philox(17, i, 0, 0);
        const float x = unit_float(words[0]), y = unit_float(words[1]), z = unit_float(words[2]);
        if (start) ray = {{0.03f, 0.02f, 0.01f}, sample_sphere(x, y), no_triangle};
        const Hit hit = hit_of(rays, ray);
        ++leaks.rays;
        leaks.escaped += hit.escaped();
        leaks.behind += !hit.escaped() && hit.chart == no_chart;
        start = hit.chart == no_chart;
        if (start) continue;
        const Frame frame = scene.charts[hit.chart].frame_about(hit.normal);
        glm::vec3 direction = sample_cosine(frame.u, frame.v, frame.normal, z, y);
        if (words[3] % 4 == 0)
            direction =
                sample_cosine(frame.u, frame.v, frame.normal, 1 - 0x1p-24f * static_cast<float>(1 + words[2] % 16), y);
        if (words[3] % 4 == 1) {
            const glm::vec3 corner = glm::normalize(scene.vertices[words[3] / 4 % 8] - hit.position);
            if (glm::dot(corner, hit.normal) > 2e-4f) direction = corner;
        }
        ray = {hit.position, direction, hit.triangle};
    }
    return leaks;
}

GltfBuilder closed_box(glm::vec3 low, glm::vec3 high) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_box("room", low, high, true);
    return file;
}

// A room of separate walls whose corners are equal numbers but not shared vertices; turned so that none is round.
GltfBuilder turned_room() {
    GltfBuilder file = closed_box({-1, -1.3f, -0.7f}, {1, 1.3f, 0.7f});
    file.json["nodes"][0]["rotation"] = {0.18257418583505536, 0.3651483716701107, 0.5477225575051661,
                                         0.7302967433402214};
    return file;
}

// A room whose floor is one rectangle, while the walls beside it end at 7 places along its edges: T-junctions, whose
// vertices rounding moves off the floor's edge.
GltfBuilder room_with_t_junctions() {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    const glm::dvec3 x = glm::normalize(glm::dvec3(0.3, 0.7, -0.2));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.1, -0.5, 0.9))), z = glm::cross(x, y);
    const auto at = [&](double a, double b, double c) { return glm::vec3(a * x + b * y + c * z); };
    file.add_polygon("floor", {at(-1, -1, -1), at(1, -1, -1), at(1, 1, -1), at(-1, 1, -1)});
    file.add_polygon("ceiling", {at(-1, -1, 1), at(-1, 1, 1), at(1, 1, 1), at(1, -1, 1)});
    constexpr int parts = 7;
    for (int k = 0; k < parts; ++k) {
        const double a = -1 + 2.0 * k / parts, b = -1 + 2.0 * (k + 1) / parts;
        const std::string name = std::to_string(k);
        file.add_polygon("south " + name, {at(b, -1, -1), at(a, -1, -1), at(a, -1, 1), at(b, -1, 1)});
        file.add_polygon("north " + name, {at(a, 1, -1), at(b, 1, -1), at(b, 1, 1), at(a, 1, 1)});
        file.add_polygon("west " + name, {at(-1, a, -1), at(-1, b, -1), at(-1, b, 1), at(-1, a, 1)});
        file.add_polygon("east " + name, {at(1, b, -1), at(1, a, -1), at(1, a, 1), at(1, b, 1)});
    }
    return file;
}

// A turned room whose sides are each cut into 7 x 7 squares, the middle 3 x 3 of which are a mesh of their own: each
// becomes a frame and what fills it, cut along lines on which rounding has moved the vertices.
GltfBuilder room_of_cut_walls() {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    const glm::dvec3 x = glm::normalize(glm::dvec3(0.3, 0.7, -0.2));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.1, -0.5, 0.9))), z = glm::cross(x, y);
    constexpr std::uint32_t parts = 7;
    for (int side = 0; side < 6; ++side) {
        const std::array<glm::dvec3, 3> axes = {x, y, z};
        const glm::dvec3 out = (side < 3 ? 1.0 : -1.0) * axes[static_cast<std::size_t>(side % 3)],
                         u = axes[static_cast<std::size_t>((side + 1) % 3)], v = glm::cross(u, out);
        std::vector<glm::vec3> points;
        for (std::uint32_t j = 0; j <= parts; ++j)
            for (std::uint32_t i = 0; i <= parts; ++i)
                points.emplace_back(out + (2.0 * i / parts - 1) * u + (2.0 * j / parts - 1) * v);
        std::vector<std::array<std::uint32_t, 3>> frame, filling;
        for (std::uint32_t j = 0; j < parts; ++j)
            for (std::uint32_t i = 0; i < parts; ++i) {
                const std::uint32_t a = j * (parts + 1) + i, up = a + parts + 1;
                auto& to = i >= 2 && i < 5 && j >= 2 && j < 5 ? filling : frame;
                to.push_back({a, a + 1, up + 1});
                to.push_back({a, up + 1, up});
            }
        file.add_mesh("frame " + std::to_string(side), points, frame);
        file.add_mesh("filling " + std::to_string(side), points, filling);
    }
    return file;
}

GltfBuilder room_with_a_block() {
    GltfBuilder file = turned_room();
    file.add_box("block", {0.2f, -0.4f, -0.7f}, {0.6f, 0.3f, 0.1f}, false);  // stands on the floor
    file.json["nodes"][1]["rotation"] = file.json["nodes"][0]["rotation"];
    return file;
}

TEST(Rays, ABoxDoesNotLeak) {
    const Leaks leaks = bounce(scene_of(turned_room()), leak_rays());
    EXPECT_EQ(leaks.escaped, 0u) << "of " << leaks.rays;
    EXPECT_EQ(leaks.behind, 0u);
}

TEST(Rays, ABoxFarFromTheOriginDoesNotLeak) {
    // The node carries it 1e5 m away; in another file its vertices are numbers of that size.
    GltfBuilder moved = turned_room();
    moved.json["nodes"][0]["translation"] = {1e5, -1e5, 0.5e5};
    const Leaks by_node = bounce(scene_of(moved), leak_rays());
    EXPECT_EQ(by_node.escaped, 0u);
    EXPECT_EQ(by_node.behind, 0u);
    const glm::vec3 far(1e5f, -1e5f, 0.5e5f);
    const Leaks by_vertex =
        bounce(scene_of(closed_box(far + glm::vec3(0.1f, 0.2f, 0.3f), far + glm::vec3(2.3f, 1.7f, 3.1f))), leak_rays());
    EXPECT_EQ(by_vertex.escaped, 0u);
    EXPECT_EQ(by_vertex.behind, 0u);
}

TEST(Rays, TJunctionsDoNotLeak) {
    const Leaks leaks = bounce(scene_of(room_with_t_junctions()), leak_rays());
    EXPECT_EQ(leaks.escaped, 0u) << "of " << leaks.rays;
}

TEST(Rays, CutWallsDoNotLeak) {
    const Scene scene = scene_of(room_of_cut_walls());
    EXPECT_EQ(scene.triangles.size(), 6u * (8 + 2));
    const Leaks leaks = bounce(scene, leak_rays());
    EXPECT_EQ(leaks.escaped, 0u) << "of " << leaks.rays;
    EXPECT_EQ(leaks.behind, 0u);
}

TEST(Rays, ABlockOnTheFloorDoesNotLeak) {
    const Leaks leaks = bounce(scene_of(room_with_a_block()), leak_rays());
    EXPECT_EQ(leaks.escaped, 0u) << "of " << leaks.rays;
    // Rays that graze a side of the block end so close to its foot that rounding puts some under the block, where its
    // back sides absorb what leaves: of these hostile rays one in a thousand at most.
    EXPECT_LT(static_cast<double>(leaks.behind), 1e-3 * static_cast<double>(leaks.rays));
}

// The gaps of T-junctions are real: of rays from a lamp at their edges, exact triangles without margins let some
// through; none of them leaves the room.
TEST(Rays, GapsOfTJunctionsAreClosed) {
    const Scene scene = scene_of(room_with_t_junctions());
    Scene strict = scene;
    for (Triangle& triangle : strict.triangles) triangle.margin = glm::vec3(0);
    const Rays rays(scene);
    int through = 0;
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const auto words = philox(8, i, 0, 0);
        const Triangle& triangle = scene.triangles[words[0] % 4];  // of floor and ceiling
        const glm::vec3 a = scene.vertices[triangle.vertices[words[1] % 3]];
        const glm::vec3 b = scene.vertices[triangle.vertices[(words[1] + 1) % 3]];
        const glm::vec3 origin(0.01f, 0.02f, 0.03f);
        const Ray ray{origin, glm::normalize(a + unit_float(words[2]) * (b - a) - origin), no_triangle};
        const auto all = [](const TriangleHit&) { return true; };
        through += !nearest_exact(strict, ray.origin, ray.direction, all).met();
        const Hit hit = hit_of(rays, ray);
        ASSERT_FALSE(hit.escaped()) << i;
        ASSERT_NE(hit.chart, no_chart) << i;
    }
    EXPECT_GT(through, 100);
}

TEST(Rays, FreeEdgesEndWithinMillionths) {
    GltfBuilder square;
    square.add_material("grey", {0.5, 0.5, 0.5});
    square.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const Scene scene = scene_of(square);
    const Rays rays(scene);
    const Hit inside = hit_of(rays, {{0.5f - 1e-6f, 0.1f, 1}, {0, 0, -1}, no_triangle});
    EXPECT_EQ(inside.chart, 0u);
    EXPECT_LT(inside.position.x, 0.5f - 0.5e-6f);  // pulled in
    EXPECT_TRUE(hit_of(rays, {{0.5f + 5e-6f, 0.1f, 1}, {0, 0, -1}, no_triangle}).escaped());
}

// One ray alone, in any group of up to 40, in any company: the same bits.
TEST(Rays, AnswersDoNotDependOnGrouping) {
    const Scene scene = read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/spheres.gltf");
    const Rays rays(scene);
    std::vector<Ray> queries;
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const auto words = philox(5, i, 0, 0);
        Ray ray;
        ray.origin = 0.4f * sample_sphere(unit_float(words[0]), unit_float(words[1]));
        ray.direction = sample_sphere(unit_float(words[2]), unit_float(words[3]));
        if (i % 4 == 0) ray.direction = glm::normalize(scene.vertices[words[2] % scene.vertices.size()] - ray.origin);
        if (i % 4 == 1) {  // from a surface
            const std::uint32_t t = words[2] % static_cast<std::uint32_t>(scene.triangles.size());
            const Chart& chart = scene.charts[scene.triangles[t].front_chart];
            ray.origin = scene.point_inside(scene.triangles[t], 0.3f, 0.3f);
            ray.direction =
                sample_cosine(chart.axis_u, chart.axis_v, chart.normal, unit_float(words[0]), unit_float(words[1]));
            ray.leaving = t;
        }
        queries.push_back(ray);
    }
    std::vector<Hit> alone(queries.size()), grouped(queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) alone[i] = hit_of(rays, queries[i]);
    for (const std::size_t group : {2u, 3u, 8u, 13u, 40u}) {
        for (std::size_t first = 0; first < queries.size(); first += group) {
            const std::size_t count = std::min<std::size_t>(group, queries.size() - first);
            rays.intersect({&queries[first], count}, {&grouped[first], count});
        }
        std::size_t different = 0;
        for (std::size_t i = 0; i < queries.size(); ++i) different += !same_bits(alone[i], grouped[i]);
        EXPECT_EQ(different, 0u) << "groups of " << group;
    }
    rays.intersect({}, {});
}

// Against a search through all triangles in double precision.
TEST(Rays, FindTheNearestTriangle) {
    std::mt19937 engine(2);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto random_point = [&] { return glm::vec3(unit(engine), unit(engine), unit(engine)); };
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.json["materials"][0]["doubleSided"] = true;
    for (int i = 0; i < 60; ++i) file.add_polygon(std::to_string(i), {random_point(), random_point(), random_point()});
    const Scene scene = scene_of(file);
    const Rays rays(scene);
    int hits = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const auto words = philox(9, i, 0, 0);
        const glm::vec3 direction = sample_sphere(unit_float(words[0]), unit_float(words[1]));
        const Ray ray{0.2f * sample_sphere(unit_float(words[2]), unit_float(words[3])), direction, no_triangle};
        const Hit hit = hit_of(rays, ray);
        double nearest = INFINITY, border = 1;
        std::uint32_t expected = no_chart;
        for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
            const auto& v = scene.triangles[t].vertices;
            const glm::dvec3 a(scene.vertices[v[0]]), e1 = glm::dvec3(scene.vertices[v[1]]) - a,
                                                      e2 = glm::dvec3(scene.vertices[v[2]]) - a, d(direction),
                                                      o(ray.origin);
            const glm::dvec3 n = glm::cross(e1, e2);
            const double distance = glm::dot(a - o, n) / glm::dot(d, n);
            const glm::dvec3 q = o + distance * d - a;
            const double b1 = glm::dot(glm::cross(q, e2), n) / glm::dot(n, n);
            const double b2 = glm::dot(glm::cross(e1, q), n) / glm::dot(n, n);
            const double least = std::min({b1, b2, 1 - b1 - b2});
            if (distance > 0) border = std::min(border, std::abs(least));
            if (distance > 0 && least > 0 && distance < nearest) nearest = distance, expected = t;
        }
        if (border < 1e-4) continue;  // undecided in float
        ASSERT_EQ(hit.triangle, expected);
        if (expected == no_chart) continue;
        ++hits;
        EXPECT_NEAR(hit.distance, nearest, 1e-4 * nearest + 1e-5);
        EXPECT_NEAR(glm::distance(hit.position, ray.origin + hit.distance * direction), 0, 2e-5);
        const Chart& chart = scene.charts[hit.chart];
        EXPECT_LT(glm::dot(chart.normal, direction), 0);  // the side that looks at the ray
        const glm::vec2 uv = chart.unit_coordinates(hit.position);
        EXPECT_EQ(hit.u, chart_fixed_point(uv.x));
        EXPECT_EQ(hit.v, chart_fixed_point(uv.y));
    }
    EXPECT_GT(hits, 10000);
}

TEST(Rays, BacksOfSingleSidedSurfacesAbsorb) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("square", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    const Scene scene = scene_of(file);
    const Rays rays(scene);
    const Hit front = hit_of(rays, {{0.1f, 0.2f, 1}, {0, 0, -1}, no_triangle});
    EXPECT_EQ(front.chart, 0u);
    EXPECT_FLOAT_EQ(front.distance, 1);
    const Hit back = hit_of(rays, {{0.1f, 0.2f, -1}, {0, 0, 1}, no_triangle});
    EXPECT_FALSE(back.escaped());
    EXPECT_EQ(back.chart, no_chart);
    EXPECT_TRUE(hit_of(rays, {{0, 0, 1}, {0, 0, 1}, no_triangle}).escaped());
}

// Rays from facet to facet inside a sphere: a concave patch sees itself, and nothing gets out between its facets.
TEST(Rays, NoLeaksInASphere) {
    for (const std::uint32_t rows : {16u, 160u}) {
        Scene scene;
        scene.materials.emplace_back();
        add_surfaces(scene, sphere_part(rows, 1, -1));
        scene.low = glm::vec3(-1);
        scene.high = glm::vec3(1);
        ASSERT_TRUE(scene.charts[0].curved);
        const Leaks leaks = bounce(scene, leak_rays());
        EXPECT_EQ(leaks.escaped, 0u) << "of " << leaks.rays;
        EXPECT_EQ(leaks.behind, 0u) << "of " << leaks.rays;
    }
}

// On the facet of a curved patch the shading normal runs from corner to corner, on the side that was hit.
TEST(Rays, ShadingNormalsOfASphere) {
    Scene scene;
    scene.materials.emplace_back();
    scene.materials[0].double_sided = true;
    add_surfaces(scene, sphere_part(32, 1, 1));
    scene.low = glm::vec3(-1);
    scene.high = glm::vec3(1);
    const Rays rays(scene);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const auto words = philox(9, i, 0, 0);
        const glm::vec3 out = sample_sphere(unit_float(words[0]), unit_float(words[1]));
        const Hit inside = hit_of(rays, {{0, 0, 0}, out, no_triangle});
        const Hit outside = hit_of(rays, {2.0f * out, -out, no_triangle});
        ASSERT_EQ(inside.triangle, outside.triangle);
        EXPECT_GT(glm::dot(outside.shading_normal, out), 0.9999f);
        EXPECT_LT(glm::dot(inside.shading_normal, out), -0.9999f);
        EXPECT_LT(glm::dot(outside.normal, out), 0.99999f + 1e-5f);
        EXPECT_GT(glm::dot(inside.normal, inside.shading_normal), 0.99f);
        EXPECT_NE(inside.normal, inside.shading_normal);
    }
}

// A rug that lies exactly in the floor: light from the rug meets neither, whatever rounding says.
TEST(Rays, NothingInThePlaneThatIsLeftIsMet) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("floor", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    file.add_polygon("rug", {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
    file.add_polygon("sheet", {{-1, -1, 0.5}, {-1, 1, 0.5}, {1, 1, 0.5}, {1, -1, 0.5}});  // faces down
    for (auto& node : file.json["nodes"])
        node["rotation"] = {0.18257418583505536, 0.3651483716701107, 0.5477225575051661, 0.7302967433402214};
    const Scene scene = scene_of(file);
    const Rays rays(scene);
    const Chart& rug = scene.charts[scene.charts_of("rug")[0]];
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const auto words = philox(4, i, 0, 0);
        const Ray ray{scene.point_inside(scene.triangles[rug.first_triangle], 0.4f * unit_float(words[0]), 0.4f),
                      sample_cosine(rug.axis_u, rug.axis_v, rug.normal, unit_float(words[1]), unit_float(words[2])),
                      rug.first_triangle};
        const Hit hit = hit_of(rays, ray);
        ASSERT_TRUE(hit.escaped() || hit.chart == scene.charts_of("sheet")[0]);
    }
}

}  // namespace
}  // namespace brewster
