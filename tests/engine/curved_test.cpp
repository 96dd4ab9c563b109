// Light on curved meshes, against closed forms (theory 6).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/philox.h"
#include "base/units.h"
#include "bins/lookup.h"
#include "bins/publish.h"
#include "engine/engine.h"
#include "engine/outlines.h"
#include "scene/curved_parts.h"
#include "slow.h"
#include "trace.h"
#include "transport/deposit.h"

namespace brewster {
namespace {

std::shared_ptr<Scene> scene_of(const Part& part, float albedo, float emission) {
    auto scene = std::make_shared<Scene>();
    scene->name = "curved";
    scene->materials.emplace_back();
    scene->materials[0].albedo = glm::vec3(albedo);
    scene->materials[0].emission = glm::vec3(emission);
    add_surfaces(*scene, part);
    scene->low = glm::vec3(-2);
    scene->high = glm::vec3(2);
    for (std::uint32_t i = 0; emission > 0 && i < scene->charts.size(); ++i) {
        Lamp lamp;
        lamp.chart = i;
        lamp.intensity = glm::vec3(emission);
        lamp.power = static_cast<float>(pi * scene->charts[i].area) * lamp.intensity;
        scene->lamps.push_back(lamp);
    }
    return scene;
}

double area_of(const Scene& scene) {
    double area = 0;
    for (const Chart& chart : scene.charts) area += chart.area;
    return area;
}

/// Mean of the bands, of direct and indirect light.
struct Light {
    double direct, indirect;
};

Light light_at(const Snapshot& bins, std::uint32_t chart, std::uint32_t u, std::uint32_t v) {
    const auto mean = [](const glm::vec3& bands) { return static_cast<double>(bands.x + bands.y + bands.z) / 3; };
    return {mean(lookup::look_up(bins, bins.charts[chart].direct_root, 0u, u, v).value),
            mean(lookup::look_up(bins, bins.charts[chart].indirect_root, 0u, u, v).value)};
}

struct Place {
    std::uint32_t chart, u, v;
};

/// Middles of triangles all over the scene, by their number; every place stands for about as much area as the next on
/// the meshes used here.
std::vector<Place> places_on(const Scene& scene, std::size_t count) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& triangle = scene.triangles[(2 * i + 1) * scene.triangles.size() / (2 * count)];
        const glm::vec2 uv =
            scene.charts[triangle.front_chart].unit_coordinates(scene.point_inside(triangle, 1 / 3.0f, 1 / 3.0f));
        places.push_back({triangle.front_chart, chart_fixed_point(uv.x), chart_fixed_point(uv.y)});
    }
    return places;
}

/// Means and standard errors over seeds: of all light over all places, and of each place.
struct Measured {
    double direct = 0, indirect = 0, direct_error = 0, indirect_error = 0, worst_place = 0;
};

Measured measured(const std::shared_ptr<Scene>& scene, std::uint64_t photons) {
    constexpr int seeds = 12;
    const std::vector<Place> places = places_on(*scene, 400);
    std::vector<double> direct, indirect, at(places.size());
    for (int seed = 1; seed <= seeds; ++seed) {
        EngineSettings settings;
        settings.threads = 2;
        settings.seed = static_cast<std::uint64_t>(seed);
        Engine engine(scene, settings);
        trace(engine, photons);
        EXPECT_EQ(engine.progress().trouble, 0u);
        Light sum{0, 0};
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Light light = light_at(*engine.snapshot(), places[i].chart, places[i].u, places[i].v);
            sum.direct += light.direct / static_cast<double>(places.size());
            sum.indirect += light.indirect / static_cast<double>(places.size());
            at[i] += (light.direct + light.indirect) / seeds;
        }
        direct.push_back(sum.direct);
        indirect.push_back(sum.indirect);
    }
    Measured m;
    const auto summarize = [](const std::vector<double>& values, double& mean, double& error) {
        double squares = 0;
        for (const double v : values) mean += v / seeds;
        for (const double v : values) squares += (v - mean) * (v - mean);
        error = std::sqrt(squares / (seeds - 1) / seeds);
    };
    summarize(direct, m.direct, m.direct_error);
    summarize(indirect, m.indirect, m.indirect_error);
    for (const double light : at) m.worst_place = std::max(m.worst_place, std::abs(light - m.direct - m.indirect));
    return m;
}

void report(const char* name, double value, double expected, double error) {
    std::printf("%s: %.5f, closed form %.5f, standard error %.5f, off by %+.2f\n", name, value, expected, error,
                (value - expected) / error);
}

// Any lamp in a sphere makes the same indirect light everywhere: the flux rho Phi / (1 - rho) over the mesh's own area,
// which a mesh of facets has in place of 4 pi R^2. That the facets are no sphere shows at the order of their angle
// squared, 1e-3 / 4 for 96 rows.
TEST(Curved, IntegratingSphere) {
    constexpr double albedo = 0.6;
    constexpr std::uint32_t rows = slow ? 48 : 96;
    const auto scene = scene_of(sphere_part(rows, 1, -1), static_cast<float>(albedo), 0);
    Lamp lamp;
    lamp.kind = LampKind::point;
    lamp.position = {0.3f, -0.2f, 0.4f};
    lamp.intensity = glm::vec3(1);
    lamp.power = point_power(lamp.intensity);
    scene->lamps.push_back(lamp);
    const double expected = albedo / (1 - albedo) * 4 * pi / area_of(*scene);
    const double facets = 3e-4 * std::pow(96.0 / rows, 2);
    const Measured m = measured(scene, slow ? 30000 : 200000);
    report("integrating sphere, indirect irradiance", m.indirect, expected, m.indirect_error);
    EXPECT_NEAR(m.indirect, expected, 3 * m.indirect_error + facets * expected);
    // A facet that shadowed itself or leaked would take a percent.
    EXPECT_GT(0.003 * expected, m.indirect_error);
}

// In a bowl, half of what any point gives off meets the bowl again, evenly: radiosity E / (1 - rho / 2), direct
// irradiance E / 2, whatever the place. No band along the rim or along the borders of patches. (Facets of 64 rows are off
// by 6e-4, less than the error of few photons; those of 192 by a ninth of that.)
TEST(Curved, GlowingBowl) {
    constexpr double albedo = 0.8, emission = 1;
    const auto scene =
        scene_of(sphere_part(slow ? 64 : 192, 1, -1, pi / 2), static_cast<float>(albedo), static_cast<float>(emission));
    const double share = area_of(*scene) / (4 * pi), radiosity = pi * emission / (1 - albedo * share);
    const Measured m = measured(scene, slow ? 30000 : 200000);
    report("bowl, direct irradiance", m.direct, pi * emission * share, m.direct_error);
    report("bowl, indirect irradiance", m.indirect, (radiosity - pi * emission) * share, m.indirect_error);
    EXPECT_NEAR(m.direct, pi * emission * share, 3 * m.direct_error);
    EXPECT_NEAR(m.indirect, (radiosity - pi * emission) * share, 3 * m.indirect_error);
    std::printf("worst of 400 places: %.4f of the mean\n", m.worst_place / (m.direct + m.indirect));
    EXPECT_LT(m.worst_place, (slow ? 0.2 : 0.04) * (m.direct + m.indirect));
}

// Light spread evenly over the true area reads as one constant: one leaf.
TEST(Curved, ConstantRadianceIsOneLeaf) {
    for (const Part& part : {sphere_part(64, 1, 1), saddle_part(64), torus_part(64, 1, 0.4)}) {
        const auto scene = scene_of(part, 0.5f, 0);
        const BinSettings settings;
        const EntryFields fields;
        BinTree<2> tree(outlines_of(*scene), fields.layout(), settings);
        Tally<2> tally(fields.layout());
        tally.resize(tree.leaf_count());
        constexpr std::uint64_t side = 6;  // 36 places a triangle, in a lattice of equal areas
        double area = 0;
        std::uint32_t replica = 0;
        for (std::uint32_t t = 0; t < scene->triangles.size(); ++t) {
            const Triangle& triangle = scene->triangles[t];
            const glm::vec3 a = scene->vertices[triangle.vertices[0]];
            const double own =
                0.5 * static_cast<double>(glm::length(glm::cross(scene->vertices[triangle.vertices[1]] - a,
                                                                 scene->vertices[triangle.vertices[2]] - a)));
            area += own;
            const glm::vec3 weight(static_cast<float>(1e4 * own / (side * side)));
            for (std::uint64_t i = 0; i < side; ++i)
                for (std::uint64_t j = 0; j < 2 * i + 1; ++j) {  // row i of a triangle cut in side^2 pieces
                    const double third = j % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
                    const double b0 = 1 - (static_cast<double>(i) + (j % 2 == 0 ? 2 / 3.0 : 1 / 3.0)) / side;
                    const double b2 = (static_cast<double>(j / 2) + third) / side;
                    Hit hit;
                    hit.chart = triangle.front_chart;
                    const glm::vec2 uv = scene->charts[hit.chart].unit_coordinates(
                        scene->point_inside(triangle, static_cast<float>(1 - b0 - b2), static_cast<float>(b2)));
                    hit.u = chart_fixed_point(uv.x);
                    hit.v = chart_fixed_point(uv.y);
                    deposit(tree, fields, tally, hit, {&weight.x, 3}, false, replica++ % replica_count);
                }
        }
        constexpr std::uint64_t photons = 100000;
        const Snapshot bins = publish(tree, fields, &tally, photons, glm::dvec3(1), settings);
        double worst = 0;
        for (std::uint32_t chart = 0; chart < scene->charts.size(); ++chart)
            EXPECT_EQ(bins.charts[chart].indirect_leaves, 1u) << chart;
        const double expected = 1e4 / photons;
        for (const Place& place : places_on(*scene, 5000))
            worst = std::max(worst, std::abs(light_at(bins, place.chart, place.u, place.v).indirect / expected - 1));
        std::printf("%zu charts, %.4f m2: worst deviation %.1e\n", scene->charts.size(), area, worst);
        EXPECT_LT(worst, 1e-3);
    }
}

// The same bits for one thread and two, and an exact ledger, where weights are corrected for shading normals.
TEST(Curved, ThreadsDoNotChangeTheDigest) {
    const auto scene = scene_of(torus_part(24, 1, 0.4), 0.7f, 1);
    std::string digests[2];
    for (const unsigned threads : {1u, 2u}) {
        EngineSettings settings;
        settings.threads = threads;
        Engine engine(scene, settings);
        trace(engine, 50000);
        const Ledger ledger = engine.ledger();
        EXPECT_TRUE(ledger.balances());
        EXPECT_NE(ledger.shading[0][0], 0);
        EXPECT_GT(ledger.capped[0][0], 0);
        EXPECT_GT(ledger.cut[0][0], 0);
        digests[threads - 1] = engine.digest();
    }
    EXPECT_EQ(digests[0], digests[1]);
}

}  // namespace
}  // namespace brewster
