#include "scene/emission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/philox.h"
#include "base/units.h"
#include "scene/gltf_builder.h"
#include "statistics/chi_square.h"

namespace brewster {
namespace {

constexpr int photons = 200000;
constexpr std::size_t chi_square_tests = 5;  // in this file: the family fails by chance once in 1e4 seeds

double level() {
    return sidak_level(1e-4, chi_square_tests);
}

std::array<float, 4> numbers(std::uint64_t photon) {
    const auto words = philox(11, photon, 0, 0);
    return {unit_float(words[0]), unit_float(words[1]), unit_float(words[2]), unit_float(words[3])};
}

// A 2 x 1 floor under one punctual light that shines obliquely.
Scene lit_floor(const nlohmann::json& light) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_polygon("floor", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = nlohmann::json::array({light});
    file.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                   {"translation", {1, 0.5, 2}},
                   {"rotation", {std::sin(0.2), 0, 0, std::cos(0.2)}}});
    return read_scene_text(file.text(), "test");
}

// An L-shaped lamp of three unit squares, unevenly cut into triangles, that faces +z.
Scene glowing_l() {
    GltfBuilder file;
    file.add_material("glow", {0, 0, 0}, 5);
    file.add_mesh("lamp", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
                  {{0, 1, 2}, {0, 2, 6}, {6, 3, 4}, {6, 4, 5}});
    return read_scene_text(file.text(), "test");
}

// Counts of photon starts in 16 x 16 cells of two coordinates of [0, 1).
template <class Coordinates>
std::vector<double> histogram(const LampSampler& sampler, const Coordinates& coordinates) {
    std::vector<double> counts(256);
    for (std::uint64_t i = 0; i < photons; ++i) {
        const auto [s, t] = coordinates(sampler.emit(0, numbers(i)));
        const int a = static_cast<int>(s * 16), b = static_cast<int>(t * 16);
        ++counts[static_cast<std::size_t>(std::min(a, 15) * 16 + std::min(b, 15))];
    }
    return counts;
}

double turns_of(double y, double x) {
    const double turns = std::atan2(y, x) / (2 * pi);
    return turns < 0 ? turns + 1 : turns;
}

TEST(Emission, OfAnAreaLampIsUniformOnItsTriangles) {
    const Scene scene = glowing_l();
    const auto counts = histogram(LampSampler(scene), [&](const Emission& emission) {
        const glm::dvec3 p = (glm::dvec3(emission.position) + scene.centre) / 2.0;
        EXPECT_NEAR(p.z, 0, 1e-7);
        return std::pair{p.x, p.y};
    });
    std::vector<double> expected(256), uneven(256);
    for (std::size_t i = 0; i < 256; ++i) {
        const bool inside = i / 16 < 8 || i % 16 < 8;
        expected[i] = inside ? photons / 192.0 : 0;
        uneven[i] = inside ? (i / 16 < 8 ? 0.98 : 1.04) * photons / 192.0 : 0;
        EXPECT_TRUE(inside || counts[i] == 0) << i;
    }
    EXPECT_GT(chi_square_test(counts, expected).p_value, level());
    EXPECT_LT(chi_square_test(counts, uneven).p_value, level());  // 2 % and 4 % off are seen
}

TEST(Emission, OfAnAreaLampFollowsTheCosine) {
    const Scene scene = glowing_l();
    const auto counts = histogram(LampSampler(scene), [](const Emission& emission) {
        const double cosine = emission.direction.z;
        EXPECT_NEAR(glm::length(emission.direction), 1, 1e-6);
        return std::pair{cosine * cosine, turns_of(emission.direction.y, emission.direction.x)};
    });
    const std::vector<double> uniform(256, photons / 256.0);  // cos^2 and azimuth are uniform
    EXPECT_GT(chi_square_test(counts, uniform).p_value, level());
    const auto wrong = histogram(LampSampler(scene), [](const Emission& emission) {
        return std::pair{static_cast<double>(emission.direction.z),
                         turns_of(emission.direction.y, emission.direction.x)};
    });
    EXPECT_LT(chi_square_test(wrong, uniform).p_value, level());
}

TEST(Emission, OfAPointIsUniformOverTheSphere) {
    const Scene scene = lit_floor({{"type", "point"}});
    const auto counts = histogram(LampSampler(scene), [&](const Emission& emission) {
        EXPECT_EQ(emission.position, scene.lamps[0].position);
        return std::pair{0.5 * (emission.direction.z + 1), turns_of(emission.direction.y, emission.direction.x)};
    });
    EXPECT_GT(chi_square_test(counts, std::vector<double>(256, photons / 256.0)).p_value, level());
}

// Cells of equal width in the cosine; the expected share is the integral of the falloff over each.
TEST(Emission, OfASpotFollowsItsFalloff) {
    const Scene scene = lit_floor({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.4}, {"outerConeAngle", 0.9}}}});
    const Lamp& lamp = scene.lamps[0];
    const double inner = lamp.cos_inner, outer = lamp.cos_outer;
    const glm::dvec3 axis(lamp.direction), u = glm::normalize(glm::cross(axis, glm::dvec3(1, 0.3, 0.1)));
    const glm::dvec3 v = glm::cross(axis, u);
    const auto counts = histogram(LampSampler(scene), [&](const Emission& emission) {
        const glm::dvec3 d(emission.direction);
        EXPECT_NEAR(glm::length(d), 1, 1e-6);
        return std::pair{std::clamp((1 - glm::dot(d, axis)) / (1 - outer), 0.0, 1.0),
                         turns_of(glm::dot(d, v), glm::dot(d, u))};
    });
    // Integral of the falloff from the axis to a cosine c.
    const auto within = [&](double c, double power) {
        const double ramp = (c - outer) / (inner - outer);
        return c >= inner ? 1 - c : (1 - inner) + (inner - outer) / (power + 1) * (1 - std::pow(ramp, power + 1));
    };
    for (const double power : {2.0, 1.0}) {  // the square, and as a control a straight ramp
        std::vector<double> expected;
        for (int i = 0; i < 256; ++i) {
            const double c0 = 1 - (i / 16) * (1 - outer) / 16, c1 = 1 - (i / 16 + 1) * (1 - outer) / 16;
            expected.push_back(photons / 16.0 * (within(c1, power) - within(c0, power)) / within(outer, power));
        }
        const double p = chi_square_test(counts, expected).p_value;
        if (power == 2.0) {
            EXPECT_GT(p, level());
        } else {
            EXPECT_LT(p, level());
        }
    }
}

TEST(Emission, OfASunCoversTheSceneFromOutside) {
    const Scene scene = lit_floor({{"type", "directional"}, {"intensity", 7}});
    const Lamp& lamp = scene.lamps[0];
    const SunRectangle sun = sun_rectangle(scene.low, scene.high, lamp.direction);
    // The floor is 2 x 1 m; the sun stands 0.4 rad from its normal, about the long side.
    EXPECT_NEAR(sun.area, 2 * std::cos(0.4), 1e-6);
    EXPECT_NEAR(lamp.power.x, 7 * 2 * std::cos(0.4), 1e-5);
    const LampSampler sampler(scene);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Emission emission = sampler.emit(0, numbers(i));
        EXPECT_EQ(emission.direction, lamp.direction);
        // Downstream it meets the floor's plane within the floor's bounds, not behind its start.
        const float distance = -emission.position.z / emission.direction.z;
        const glm::vec3 p = emission.position + distance * emission.direction;
        EXPECT_GT(distance, 0);
        EXPECT_LT(std::abs(p.x), 1 + 1e-5);
        EXPECT_LT(std::abs(p.y), 0.5 + 1e-5);
    }
    const auto counts = histogram(sampler, [&](const Emission& emission) {
        const glm::vec3 p = emission.position - (emission.position.z / emission.direction.z) * emission.direction;
        return std::pair{std::clamp(0.5 * p.x + 0.5, 0.0, 1.0), std::clamp(p.y + 0.5, 0.0, 1.0)};
    });
    EXPECT_GT(chi_square_test(counts, std::vector<double>(256, photons / 256.0)).p_value, level());
}

// Every corner of the bounds lies within the beam, for suns from everywhere.
TEST(Emission, SunRectanglesCoverTheBounds) {
    const glm::vec3 low(-1, -2, -0.5f), high(1, 2, 0.5f);
    for (std::uint64_t i = 0; i < 200; ++i) {
        const auto x = numbers(i);
        const glm::vec3 direction =
            i < 6 ? glm::vec3(i == 0, i == 1, i == 2) - glm::vec3(i == 3, i == 4, i == 5) : sample_sphere(x[0], x[1]);
        const SunRectangle sun = sun_rectangle(low, high, direction);
        EXPECT_NEAR(sun.area, 4 * glm::length(sun.half_u) * glm::length(sun.half_v), 1e-4);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
            const glm::vec3 d = p - sun.centre;
            EXPECT_GT(glm::dot(d, direction), 0);
            EXPECT_LT(std::abs(glm::dot(d, sun.half_u)), glm::dot(sun.half_u, sun.half_u) * (1 + 1e-5f));
            EXPECT_LT(std::abs(glm::dot(d, sun.half_v)), glm::dot(sun.half_v, sun.half_v) * (1 + 1e-5f));
        }
    }
}

// Light of a disc crosses the rectangle evenly, from everywhere on the disc with its cosine, and covers the bounds from
// every side of it; the power that crosses is the irradiance times the rectangle.
TEST(Emission, OfASunWithADiscCoversTheSceneFromAllOfIt) {
    const Scene scene = lit_floor(
        {{"type", "directional"}, {"intensity", 7}, {"extensions", {{"BREWSTER_surface", {{"angularDiameter", 20}}}}}});
    const Lamp& lamp = scene.lamps[0];
    ASSERT_GT(lamp.angular_radius, 0);
    const SunRectangle sun = sun_rectangle(scene.low, scene.high, lamp.direction, lamp.angular_radius);
    EXPECT_GT(sun.area, 2 * std::cos(0.4));
    EXPECT_NEAR(lamp.power.x, 7 * sun.area, 1e-4);
    const LampSampler sampler(scene);
    // The floor is hit with its share: cosine of the middle direction over that of the disc's mean, exactly E A cos.
    double on_floor = 0;
    const std::uint64_t n = 40000;
    for (std::uint64_t i = 0; i < n; ++i) {
        const Emission emission = sampler.emit(0, numbers(i));
        EXPECT_GE(glm::dot(emission.direction, lamp.direction), std::cos(lamp.angular_radius) - 1e-6f);
        EXPECT_NEAR(sampler.pdf(0, emission.direction) * sun.area, pdf_disc(lamp, emission.direction), 1e-3);
        const glm::vec3 p = emission.position - (emission.position.z / emission.direction.z) * emission.direction;
        on_floor += std::abs(p.x) < 1 && std::abs(p.y) < 0.5f;
    }
    // Irradiance of a disc wholly above the horizon is that of its middle: integral of L (n.d) = n . integral of L d.
    const double share = on_floor / static_cast<double>(n),
                 expected = 2 * std::cos(0.4) / static_cast<double>(sun.area);
    EXPECT_NEAR(share, expected, 4 * std::sqrt(expected / static_cast<double>(n)));
}

// Densities integrate to 1: the mean of density x 4 pi over uniform directions; 1e6 of them, of a standard deviation
// below 4 (spot: 1/share of the sphere), so 5 sigma are 0.02.
TEST(Emission, DensitiesIntegrateToOne) {
    for (const nlohmann::json& light :
         {nlohmann::json{{"type", "point"}},
          nlohmann::json{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.4}, {"outerConeAngle", 0.9}}}},
          nlohmann::json{{"type", "spot"}, {"spot", {{"innerConeAngle", 0.9}, {"outerConeAngle", 0.9}}}}}) {
        const Scene scene = lit_floor(light);
        const LampSampler sampler(scene);
        double sum = 0;
        for (std::uint64_t i = 0; i < 1000000; ++i) {
            const auto words = philox(3, i, 0, 0);
            sum += sampler.pdf(0, sample_sphere(unit_float(words[0]), unit_float(words[1])));
        }
        EXPECT_NEAR(sum / 1e6 * 4 * pi, 1, 0.02) << light;
    }
    const Scene scene = glowing_l();
    EXPECT_NEAR(LampSampler(scene).pdf(0, {0, 0, 1}), 1 / (3 * pi), 1e-7);
    EXPECT_EQ(LampSampler(scene).pdf(0, {0, 0, -1}), 0);
}

// Power over density is the radiant intensity (point, spot), the radiance (area), the irradiance (sun) of the lamp.
TEST(Emission, PowerAndDensityGiveTheIntensity) {
    const Scene spot =
        lit_floor({{"type", "spot"}, {"intensity", 9}, {"spot", {{"innerConeAngle", 0.4}, {"outerConeAngle", 0.9}}}});
    EXPECT_NEAR(spot.lamps[0].power.x * LampSampler(spot).pdf(0, spot.lamps[0].direction), 9, 1e-4);
    const Scene point = lit_floor({{"type", "point"}, {"intensity", 9}});
    EXPECT_NEAR(point.lamps[0].power.x * LampSampler(point).pdf(0, {1, 0, 0}), 9, 1e-4);
    const Scene area = glowing_l();  // density over area and solid angle: L cos
    EXPECT_NEAR(area.lamps[0].power.x * LampSampler(area).pdf(0, {0, 0.6f, 0.8f}), 5 * 0.8, 1e-5);
    const Scene sun = lit_floor({{"type", "directional"}, {"intensity", 9}});
    EXPECT_NEAR(sun.lamps[0].power.x * LampSampler(sun).pdf(0, sun.lamps[0].direction), 9, 1e-4);
}

// Eight photons of lamps of all kinds at a time: each starts as alone, to the bit.
TEST(Emission, LanesGetTheBitsOfOne) {
    Scene scene = glowing_l();
    for (const LampKind kind : {LampKind::point, LampKind::spot, LampKind::sun, LampKind::sun}) {
        Lamp& lamp = scene.lamps.emplace_back();
        lamp.kind = kind;
        lamp.direction = glm::normalize(glm::vec3(0.3f, -0.2f, -1));
        lamp.cos_inner = 0.95f;
        lamp.cos_outer = 0.8f;
        lamp.angular_radius = scene.lamps.size() == 5 ? 0.1f : 0.0f;
    }
    const LampSampler sampler(scene);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        std::array<std::array<float, lane_count>, 4> x;
        std::array<std::uint32_t, lane_count> lamps, leaving;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const auto drawn = numbers(lane_count * i + lane);
            for (std::size_t d = 0; d < 4; ++d) x[d][lane] = drawn[d];
            // Some batches hold one kind alone.
            lamps[lane] = i % 4 == 0 ? static_cast<std::uint32_t>(i / 4 % 5) : philox(12, i, 0, 0)[lane / 2] % 5;
        }
        std::array<FloatLanes, 4> lanes;
        for (std::size_t d = 0; d < 4; ++d) lanes[d] = load<FloatLanes>(x[d].data());
        const PhotonStart<FloatLanes> start = sampler.start<FloatLanes>(load_words(lamps.data()), lanes);
        store(start.leaving, leaving.data());
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const Emission one = sampler.emit(lamps[lane], {x[0][lane], x[1][lane], x[2][lane], x[3][lane]});
            const glm::vec3 position(start.position.x[lane], start.position.y[lane], start.position.z[lane]);
            const glm::vec3 direction(start.direction.x[lane], start.direction.y[lane], start.direction.z[lane]);
            ASSERT_EQ(position, one.position);
            ASSERT_EQ(direction, one.direction);
            ASSERT_EQ(leaving[lane], one.leaving);
        }
    }
}

// The extremes of the numbers stay inside lamp and cone, and no direction is tangent to its lamp.
TEST(Emission, ExtremeNumbersAreSafe) {
    const float last = 1 - 0x1p-24f;
    const Scene area = glowing_l();
    const Scene spot = lit_floor({{"type", "spot"}, {"spot", {{"innerConeAngle", 0}, {"outerConeAngle", 0.001}}}});
    const LampSampler of_area(area), of_spot(spot);
    for (int bits = 0; bits < 16; ++bits) {
        const std::array<float, 4> x = {bits & 1 ? last : 0, bits & 2 ? last : 0, bits & 4 ? last : 0,
                                        bits & 8 ? last : 0};
        const Emission a = of_area.emit(0, x), s = of_spot.emit(0, x);
        EXPECT_GT(a.direction.z, 0);
        const glm::dvec3 p = glm::dvec3(a.position) + area.centre;
        EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < 2 && p.y < 2 && (p.x < 1 || p.y < 1)) << p.x << " " << p.y;
        EXPECT_NEAR(glm::length(s.direction), 1, 1e-6);
        EXPECT_GE(glm::dot(s.direction, spot.lamps[0].direction), spot.lamps[0].cos_outer - 1e-7f);
    }
}

}  // namespace
}  // namespace brewster
