#include "scene/lamp_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optics/random_light.h"
#include "scene/emission.h"
#include "scene/gltf_builder.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

/// Two square lamps of different brightness above a floor, 1 x 1 and 2 x 2.
Scene two_lamps() {
    GltfBuilder builder;
    const int dim = builder.add_material("dim", {0, 0, 0}, 1), bright = builder.add_material("bright", {0, 0, 0}, 3);
    const int floor = builder.add_material("floor", {0.5, 0.5, 0.5});
    builder.add_polygon("floor", {{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}, floor);
    builder.add_polygon("small", {{0, 2, 0}, {0, 2, -1}, {1, 2, -1}, {1, 2, 0}}, dim);
    builder.add_polygon("large", {{-2, 2, 2}, {-2, 2, 0}, {0, 2, 0}, {0, 2, 2}}, bright);
    return read_scene_text(builder.text(), "lamps");
}

/// A square of half side a at height h straight above a point: E = L pi F of a differential area, in closed form
/// (Howell, configuration B-4, four times the corner's).
double irradiance_below_corner(double a, double b, double h) {
    const double x = a / h, y = b / h;
    return 0.5 * (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                  y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y)));
}

/// Of L cos/pdf, whose mean is the irradiance.
struct Irradiance {
    double mean = 0, spread = 0, error = 0;  ///< error: of the mean
};

/// At a point below the corner that both lamps share; each sample has the density that is told of its place.
Irradiance sampled_irradiance(std::uint64_t seed, double depth) {
    const Scene scene = two_lamps();
    const LampLights lamps(scene);
    RandomLight random(seed);
    const Vector<double> point = vector_of(glm::vec3(glm::dvec3(0, 2 - depth, 0) - scene.centre));
    Irradiance found;
    double squares = 0;
    const int draws = 100000 / light_test_scale;
    for (int n = 0; n < draws; ++n) {
        const auto light = lamps.sample(point, random.unit(), random.unit(), random.unit());
        if (!light) {
            ADD_FAILURE() << "a sample without light";
            return found;
        }
        const double x = light->radiance.x * light->direction.y / light->pdf;
        found.mean += x / draws;
        squares += x * x / draws;
        const std::uint32_t chart = scene.lamps[light->lamp].chart;
        EXPECT_NEAR(lamps.pdf_of_area(chart, light->triangle, point, vector_of(scene.charts[chart].normal),
                                      light->direction, light->distance),
                    light->pdf, 1e-9 * light->pdf);
        EXPECT_NEAR(light->direction.y * light->distance, depth, 1e-5);
    }
    found.spread = std::sqrt(squares - found.mean * found.mean);
    found.error = found.spread / std::sqrt(draws);
    return found;
}

double true_irradiance(double depth) {
    return irradiance_below_corner(1, 1, depth) + 3 * irradiance_below_corner(2, 2, depth);
}

/// 4.5 standard errors.
TEST(LampLights, SamplesGiveTheIrradiance) {
    const Irradiance found = sampled_irradiance(1, 2);
    EXPECT_NEAR(found.mean, true_irradiance(2), 4.5 * found.error);
    EXPECT_LT(4.5 * found.error, 0.05 * true_irradiance(2));  // so that 5 % would be noticed
}

/// A hundredth of a metre below, light comes from nearly all of a quarter of the sky for each lamp, and by solid angle no
/// sample is far from the mean. (By area the spread is 100 times the mean.)
TEST(LampLights, NearLampsAreSampledBySolidAngle) {
    const Irradiance found = sampled_irradiance(5, 0.01);
    EXPECT_NEAR(found.mean, true_irradiance(0.01), 4.5 * found.error);
    EXPECT_LT(found.spread, 3 * found.mean);
}

TEST(LampLights, NothingComesFromBehindALamp) {
    const Scene scene = two_lamps();
    const LampLights lamps(scene);
    const Vector<double> above = vector_of(glm::vec3(glm::dvec3(0.5, 3, -0.5) - scene.centre));
    RandomLight random(2);
    for (int n = 0; n < 100; ++n) EXPECT_FALSE(lamps.sample(above, random.unit(), random.unit(), random.unit()));
}

/// A sun's disc: irradiance across the beam as without one, directions within the radius, their density uniform.
TEST(LampLights, SunsDisc) {
    Scene scene;
    Lamp sun;
    sun.kind = LampKind::sun;
    sun.intensity = glm::vec3(7.0f);
    sun.power = glm::vec3(1.0f);
    sun.angular_radius = 0.05f;
    scene.lamps.push_back(sun);
    const LampLights lamps(scene);
    RandomLight random(3);
    double irradiance = 0, inner = 0;
    const int draws = 20000;
    for (int n = 0; n < draws; ++n) {
        const auto light = lamps.sample({0, 0, 0}, random.unit(), random.unit(), random.unit());
        ASSERT_TRUE(light);
        ASSERT_GE(light->direction.z, std::cos(0.05) - 1e-12);
        irradiance += light->radiance.x * light->direction.z / light->pdf / draws;
        if (1 - light->direction.z < 0.5 * (1 - std::cos(0.05))) inner += 1.0 / draws;
        int seen = 0;
        lamps.discs_seen(light->direction, [&](const LampLight& disc) {
            ++seen;
            ASSERT_NEAR(disc.pdf, light->pdf, 1e-9 * light->pdf);
        });
        ASSERT_EQ(seen, 1);
    }
    EXPECT_NEAR(irradiance, 7, 1e-3);
    EXPECT_NEAR(inner, 0.5, 4.5 * 0.5 / std::sqrt(draws));
    lamps.discs_seen(normalized(Vector<double>{0.06, 0, 1}), [](const LampLight&) { FAIL(); });
}

/// I/d^2 and the cone's falloff; zero outside.
TEST(LampLights, Spot) {
    Scene scene;
    Lamp spot;
    spot.kind = LampKind::spot;
    spot.intensity = glm::vec3(8.0f);
    spot.power = glm::vec3(1.0f);
    spot.cos_inner = 0.9f;
    spot.cos_outer = 0.5f;
    scene.lamps.push_back(spot);
    const LampLights lamps(scene);
    const auto below = [&](double x, double z) { return lamps.sample({x, 0, z}, 0.5, 0.5, 0.5); };
    EXPECT_NEAR(below(0, -2)->radiance.x, 2, 1e-12);
    EXPECT_FALSE(below(2, -1));  // cos = .447
    EXPECT_NEAR(below(1, -1)->radiance.x, 4 * std::pow((std::sqrt(0.5) - 0.5) / 0.4, 2), 1e-6);
    EXPECT_EQ(below(0, -2)->pdf, 0);
}

/// Across every direction, also along the lamp's own x axis.
TEST(LampLights, AxisIsAcrossTheDirection) {
    Lamp lamp;
    RandomLight random(4);
    for (int n = 0; n < 100; ++n) {
        const Vector<double> direction = n == 0 ? Vector<double>{1, 0, 0} : random.direction();
        const Vector<double> axis = lamp_axis(lamp, direction);
        EXPECT_NEAR(dot(axis, direction), 0, 1e-9);
        EXPECT_NEAR(dot(axis, axis), 1, 1e-12);
    }
    EXPECT_NEAR(lamp_axis(lamp, {0, 0, -1}).x, 1, 1e-12);
}

}  // namespace
}  // namespace brewster
