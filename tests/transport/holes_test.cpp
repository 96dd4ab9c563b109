#include <gtest/gtest.h>

#include <cmath>

#include "rooms.h"
#include "transport/scalar.h"

namespace brewster {
namespace {

// A black floor of 2 m x 2 m under a small lamp, and half way a black sheet of the floor's size, cut out by a texture of
// two columns: the left half lets light through.
Scene floor_under_sheet(bool with_sheet, std::uint8_t alpha_left, std::uint8_t alpha_right) {
    Scene scene;
    const auto add = [&](glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v, const Material& material) {
        const auto vertex = static_cast<std::uint32_t>(scene.vertices.size());
        Chart chart;
        chart.material = static_cast<std::uint32_t>(scene.materials.size());
        chart.surface = static_cast<std::uint32_t>(scene.charts.size());
        chart.first_triangle = static_cast<std::uint32_t>(scene.triangles.size());
        chart.triangle_count = 2;
        chart.origin = corner;
        chart.size_u = std::sqrt(edge_u.x * edge_u.x + edge_u.y * edge_u.y + edge_u.z * edge_u.z);
        chart.size_v = std::sqrt(edge_v.x * edge_v.x + edge_v.y * edge_v.y + edge_v.z * edge_v.z);
        chart.axis_u = edge_u / chart.size_u;
        chart.axis_v = edge_v / chart.size_v;
        chart.normal = {chart.axis_u.y * chart.axis_v.z - chart.axis_u.z * chart.axis_v.y,
                        chart.axis_u.z * chart.axis_v.x - chart.axis_u.x * chart.axis_v.z,
                        chart.axis_u.x * chart.axis_v.y - chart.axis_u.y * chart.axis_v.x};
        chart.area = static_cast<double>(chart.size_u * chart.size_v);
        scene.materials.push_back(material);
        for (const glm::vec3 place : {corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v})
            scene.vertices.push_back(place);
        for (const glm::vec2 place : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
            scene.texture_coordinates.push_back(place);
        for (const std::uint32_t last : {2u, 3u}) {
            Triangle triangle;
            triangle.vertices = {vertex, vertex + last - 1, vertex + last};
            triangle.front_chart = static_cast<std::uint32_t>(scene.charts.size());
            triangle.surface = chart.surface;
            scene.triangles.push_back(triangle);
        }
        scene.charts.push_back(chart);
    };
    Material black;
    black.albedo = glm::vec3(0.0f);
    add({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, black);
    if (with_sheet) {
        Material sheet = black;
        sheet.texture = 0;
        sheet.alpha_cutoff = 0.5f;
        add({-1, 0.5f, 1}, {2, 0, 0}, {0, 0, -2}, sheet);
        SurfaceTexture texture;
        texture.width = 2;
        texture.height = 1;
        texture.nearest = true;
        texture.texels = std::make_shared<const std::vector<std::uint8_t>>(
            std::vector<std::uint8_t>{0, 0, 0, alpha_left, 0, 0, 0, alpha_right});
        scene.textures.push_back(texture);
    }
    Lamp lamp;
    lamp.kind = LampKind::point;
    lamp.position = {0, 1, 0};
    lamp.intensity = glm::vec3(1.0f);
    lamp.power = point_power(lamp.intensity);
    scene.lamps.push_back(lamp);
    scene.low = {-1, 0, -1};
    scene.high = {1, 1, 1};
    return scene;
}

struct Tallied {
    WorkerSums sums;
    std::vector<double> flux;  // direct, of a chart, lumen of band 0
};

Tallied traced(const Scene& scene, std::uint64_t photons) {
    const Rays rays(scene);
    const PhotonEmission emission(scene, 1);
    std::vector<Outline> outlines(scene.charts.size());
    for (Outline& outline : outlines)
        outline.triangles = {{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1)},
                             {glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}};
    BinSettings settings;
    settings.fixed_grid_log2 = 0;
    const BinTree<2> tree(outlines, {}, settings);
    const ScalarTransport transport(scene, rays, emission, tree, 1);
    Tallied result;
    result.sums.bins.resize(tree.leaf_count());
    for (std::uint64_t photon = 0; photon < photons; ++photon) transport.trace(photon, result.sums);
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart)
        result.flux.push_back(to_weight(*result.sums.bins.estimate(tree.node(chart).leaf())) * emission.mean_power() /
                              static_cast<double>(photons));
    return result;
}

// A sheet that is all hole changes nothing on the floor, and holds what it would receive if it were solid.
TEST(Holes, CountAsNothing) {
    constexpr std::uint64_t photons = 40000;
    const Tallied open = traced(floor_under_sheet(false, 0, 0), photons);
    const Tallied holes = traced(floor_under_sheet(true, 0, 0), photons);
    const Tallied solid = traced(floor_under_sheet(true, 255, 255), photons);
    const Tallied half = traced(floor_under_sheet(true, 0, 255), photons);
    for (const Tallied* each : {&open, &holes, &solid, &half}) EXPECT_TRUE(each->sums.ledger.balances());

    // The photons are the same, and but for rounding at the edges so are their hits.
    EXPECT_NEAR(holes.flux[0], open.flux[0], 1e-3 * open.flux[0]);
    EXPECT_NEAR(holes.flux[1], solid.flux[1], 1e-3 * solid.flux[1]);
    EXPECT_EQ(solid.flux[0], 0.0);
    EXPECT_NEAR(half.flux[1], solid.flux[1], 1e-3 * solid.flux[1]);
    // Half of what passes the plane of the sheet passes its left half: all the lower sheet's light that the floor gets,
    // as the floor, seen from the lamp through the sheet, lies within it.
    EXPECT_NEAR(half.flux[0], 0.5 * open.flux[0], 0.02 * open.flux[0]);  // 6700 photons: 3 sigma of sqrt(N)/2
    EXPECT_EQ(holes.sums.ledger.absorbed, open.sums.ledger.absorbed);
    EXPECT_GT(solid.sums.ledger.absorbed[0], holes.sums.ledger.absorbed[0]);  // it is nearer the lamp
}

}  // namespace
}  // namespace brewster
