// Surfaces that nobody should model and everybody does.
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "engine/slow.h"
#include "hard/hard.h"

namespace brewster {
namespace {

constexpr std::uint64_t photons_a_shape = slow ? 4000 : 40000;

// Radiosity in a closed room of one albedo, whatever its shape: emitted power over area (1 - rho).
SceneFile furnace(double albedo) {
    SceneFile file;
    file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(albedo));
    file.bulb(1, {0.3, 0.4, 0.6});
    return file;
}

// A floor cut in a fan of slivers, a ten-millionth of a metre at their narrow ends: they lose no light.
TEST(Shapes, Slivers) {
    SceneFile file;
    const int grey = file.material(0.5);
    const auto wall = [&](const char* name, glm::vec3 corner, glm::vec3 along, glm::vec3 up) {
        file.quad(name, corner, along, up, grey);
    };
    wall("ceiling", {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    wall("left", {0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    wall("right", {1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    wall("back", {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    wall("front", {0, 0, 1}, {0, 1, 0}, {1, 0, 0});
    std::vector<glm::vec3> vertices = {{0, 0, 0}, {1, 0, 0}};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr int steps = 40;  // towards the far edge, ever thinner
    for (int i = 0; i <= steps; ++i) {
        const float z = i == steps ? 1.0f : 1.0f - std::pow(10.0f, -7.0f * static_cast<float>(i) / (steps - 1));
        if (i == 0) continue;
        vertices.push_back({0, 0, z});
        vertices.push_back({1, 0, z});
        const auto n = static_cast<std::uint32_t>(vertices.size());
        triangles.push_back({n - 4, n - 2, n - 3});
        triangles.push_back({n - 3, n - 2, n - 1});
    }
    file.triangles("floor", vertices, triangles, grey);
    file.bulb(1, {0.3, 0.4, 0.6});
    const Solved result = solved(file, photons_a_shape);
    EXPECT_LT(result.escaped, 1e-6);
    expect_value(result.everywhere, 4 * pi / (6 * 0.5), "slivers");
}

// A second floor in the plane of the first, of the same albedo: one of both gets the light, none is lost.
TEST(Shapes, CoincidentFaces) {
    SceneFile file = furnace(0.5);
    file.quad("again", {0.2f, 0, 0.8f}, {0.6f, 0, 0}, {0, 0, -0.6f}, file.material(0.5));
    const Solved result = solved(file, photons_a_shape);
    EXPECT_EQ(result.escaped, 0);
    double flux = 0;
    for (std::uint32_t i = 0; i < result.irradiance.size(); ++i)
        flux += result.irradiance[i].mean * result.scene->charts[i].area;
    EXPECT_NEAR(flux, 4 * pi / 0.5, 0.01 * 4 * pi / 0.5);
}

// A wall that cuts through two others: light ends at its sides.
TEST(Shapes, CrossingFaces) {
    SceneFile file = furnace(0.5);
    file.quad("blade", {0.6f, -0.5f, -0.5f}, {0, 0, 2}, {0, 2, 0}, file.material(0));
    const Solved result = solved(file, photons_a_shape);
    EXPECT_LT(result.escaped, 1e-6);
    const std::vector<std::uint32_t> room = result.scene->charts_of("room");
    const Measured* beyond = nullptr;  // the wall behind the blade, seen from the bulb
    for (const std::uint32_t chart : room)
        if (result.scene->charts[chart].normal.x < -0.9f) beyond = &result.irradiance[chart];
    ASSERT_NE(beyond, nullptr);
    EXPECT_EQ(beyond->mean, 0);
}

// A lamp in the plane of its wall, as in many a model: its light is that of a lamp in front of a wall.
TEST(Shapes, LampOnAWall) {
    const auto lit = [](float distance) {
        SceneFile file;
        file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(0));
        file.quad("lamp", {0.25f, 1 - distance, 0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f}, file.material(0, 10));
        return solved(file, photons_a_shape);
    };
    const Solved on = lit(0), before = lit(1e-4f);
    EXPECT_EQ(on.escaped, 0);
    EXPECT_NEAR(on.everywhere.mean, before.everywhere.mean, 2e-3 * before.everywhere.mean);
    for (std::size_t wall = 0; wall < 6; ++wall)
        EXPECT_NEAR(
            on.on("room", wall).mean, before.on("room", wall).mean,
            4 * (on.on("room", wall).error + before.on("room", wall).error) + 2e-3 * before.on("room", wall).mean);
}

// A hundred thousand charts: tiles of many heights below a sun, each as bright as the sun makes it.
TEST(Shapes, ManyCharts) {
    constexpr int side = slow ? 60 : 316;
    SceneFile file;
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const auto x = static_cast<float>(i), z = static_cast<float>(j),
                       y = 0.01f * static_cast<float>(i * side + j);
            const auto n = static_cast<std::uint32_t>(vertices.size());
            for (const glm::vec3& corner : {glm::vec3(x, y, z + 1), {x + 1, y, z + 1}, {x + 1, y, z}, {x, y, z}})
                vertices.push_back(corner);
            triangles.push_back({n, n + 1, n + 2});
            triangles.push_back({n, n + 2, n + 3});
        }
    file.triangles("tiles", vertices, triangles, file.material(0));
    file.sun(100, {0, -1, 0});
    const Scene scene = file.read();
    EXPECT_EQ(scene.charts.size(), static_cast<std::size_t>(side * side));
    EngineSettings settings;
    settings.threads = 2;
    Engine engine(std::make_shared<const Scene>(scene), settings);
    engine.start({slow ? 20000 : 200000, {}, {}});
    engine.wait();
    EXPECT_TRUE(engine.ledger().balances());
    EXPECT_LT(engine.progress().bytes, std::uint64_t{1} << 30);
}

}  // namespace
}  // namespace brewster
