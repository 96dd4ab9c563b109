#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "display/map_colours.h"
#include "gather/gather_test.h"
#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "scene/test_materials.h"

/// Sheets of filters before the eye, before the lamp, and the eye's own (theory 1.1 to 1.3).
namespace brewster {
namespace {

using test_materials::filter;

Material polarizer(double degrees) {
    return filter(FilterKind::polarizer, static_cast<float>(radians(degrees)));
}

/// Filters one behind the other between the camera and a lamp of radiance 1; the camera rolled by `roll` about its view,
/// counter-clockwise for who looks along it.
StokesPicture through(const std::vector<Material>& sheets, double roll = 0) {
    HandMade room;
    room.square("lamp", {0, 0, -9}, {0, 0, 1}, 2, room.add(emitter(glm::vec3(1.0f))));
    for (std::size_t k = 0; k < sheets.size(); ++k)
        room.square("filter", {0, 0, -1 - static_cast<double>(k)}, {0, 0, 1}, 0.5, room.add(sheets[k]));
    const auto scene = room.finish();
    Camera camera = looking({0, 0, 1}, {0, 0, -1}, 0.01);
    const glm::dvec3 up(camera.up), right(camera.right());
    camera.up = glm::vec3(std::cos(roll) * up - std::sin(roll) * right);
    return gathered(scene, even_bins(*scene, 0, 0), camera, 2, 2, 4);
}

glm::dvec3 first_pixel(const StokesPicture& picture, Plane plane) {
    return glm::dvec3(picture.of(plane)[0]);
}

/// Crossed polarizers with a plate between them, its fast axis at b: T = 1/2 sin^2 2b sin^2(G/2); parallel ones: 1/2 less
/// that. A plate of its own retardance for each band makes colours; without polarization each polarizer passes half.
TEST(GatherFilters, WaveplatesBetweenPolarizersMakeColours) {
    const glm::dvec3 retardance(radians(130), radians(250), radians(480));
    for (const double b : {45.0, 20.0})
        for (const bool crossed : {true, false}) {
            const Material plate = filter(FilterKind::retarder, static_cast<float>(radians(b)), glm::vec3(retardance));
            const StokesPicture seen = through({polarizer(crossed ? 90 : 0), plate, polarizer(0)});
            for (int band = 0; band < 3; ++band) {
                const double passed =
                    0.5 * std::pow(std::sin(radians(2 * b)), 2) * std::pow(std::sin(0.5 * retardance[band]), 2);
                EXPECT_NEAR(first_pixel(seen, Plane::s0)[band], crossed ? passed : 0.5 - passed, 2e-5) << b;
                EXPECT_NEAR(first_pixel(seen, Plane::unpolarized)[band], 0.25, 2e-5);
            }
        }
}

/// The frame of a picture is the camera's: turned by t, S1' + i S2' = (S1 + i S2) e^(-2 i t), so that the angle of
/// polarization falls by t. S3 stays.
TEST(GatherFilters, AnglesShiftAgainstTheRollOfTheCamera) {
    const Material plate = filter(FilterKind::retarder, 0.0f, glm::vec3(static_cast<float>(radians(35))));
    for (const double roll : {0.0, 10.0, 37.0, -80.0}) {
        const StokesPicture seen = through({plate, polarizer(30)}, radians(roll));
        const StokesPicture level = through({plate, polarizer(30)});
        const double s1 = first_pixel(level, Plane::s1).x, s2 = first_pixel(level, Plane::s2).x;
        const double c = std::cos(radians(2 * roll)), s = std::sin(radians(2 * roll));
        EXPECT_NEAR(first_pixel(seen, Plane::s1).x, c * s1 + s * s2, 1e-5) << roll;
        EXPECT_NEAR(first_pixel(seen, Plane::s2).x, c * s2 - s * s1, 1e-5) << roll;
        EXPECT_NEAR(first_pixel(seen, Plane::s3).x, first_pixel(level, Plane::s3).x, 1e-5) << roll;
        EXPECT_GT(std::abs(first_pixel(level, Plane::s3).x), 0.1);
        const double angle = 0.5 * std::atan2(first_pixel(seen, Plane::s2).x, first_pixel(seen, Plane::s1).x);
        const double before = 0.5 * std::atan2(s2, s1);
        EXPECT_NEAR(std::remainder(angle - before + radians(roll), pi), 0, 1e-4) << roll;
    }
}

/// Light of a polarizer in the scene through the analyzer at the camera: 1/2 cos^2 of the angle between them.
TEST(GatherFilters, MalusAtTheCamera) {
    for (const double sheet : {0.0, 25.0, 90.0}) {
        const StokesPicture seen = through({polarizer(sheet)});
        const auto value = [&](Plane plane) { return seen.of(plane)[0].x; };
        for (const double analyzer : {0.0, 30.0, 60.0, 115.0}) {
            const double twice = radians(2 * analyzer);
            const glm::vec4 passed =
                maps::analysed({value(Plane::s0), value(Plane::s1), value(Plane::s2), value(Plane::s3)},
                               {static_cast<float>(std::cos(twice)), static_cast<float>(std::sin(twice)), 0.0f, 1.0f});
            const double cosine = std::cos(radians(analyzer - sheet));
            EXPECT_NEAR(static_cast<double>(passed.x), 0.5 * cosine * cosine, 1e-5) << sheet << " " << analyzer;
        }
    }
}

/// Malus in a scene: a point lamp behind two sheets lights a wall, whose light the bins hold, since it has passed
/// something. Photons alone decide; 3 standard errors of 4 seeds, which know the light to
/// 5 % of the bare wall's. Crossed with a third: 1/2 cos^2 t sin^2 t.
TEST(GatherFilters, MalusOnAWall) {
    const auto wall_light = [](const std::vector<Material>& sheets, Plane plane) {
        HandMade room;
        room.square("wall", {0, 0, 0}, {0, 0, 1}, 0.1, room.add(grey(0.5f)));
        for (std::size_t k = 0; k < sheets.size(); ++k)
            room.square("sheet", {0, 0, 1 + 0.1 * static_cast<double>(k)}, {0, 0, 1}, 0.5, room.add(sheets[k]));
        Lamp sun;  // straight at the wall: its photons meet every sheet head on
        sun.kind = LampKind::sun;
        sun.intensity = glm::vec3(2.0f);
        sun.direction = {0, 0, -1};
        room.lamp(sun);
        const auto scene = room.finish();
        const Camera camera = looking({0, 0.05, 0.6}, {0, 0, 0}, 5);
        constexpr int seeds = 4;
        PlaneMean all;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const auto bins = solved_bins(scene, 5'000, seed);
            const double mean = mean_of(gathered(scene, bins, camera, 4, 4, 1), plane).mean;
            all.mean += mean / seeds;
            all.error += mean * mean / seeds;
        }
        all.error = std::sqrt(std::max(all.error - all.mean * all.mean, 0.0) / (seeds - 1));
        return all;
    };
    const auto expect = [](const PlaneMean& seen, double expected) {
        EXPECT_NEAR(seen.mean, expected, 3 * seen.error + 1e-5);
        EXPECT_LT(seen.error, 0.05 * 1 / pi);
    };
    const double bare = 1 / pi;  // 2 lux, albedo 1/2
    for (const double t : {30.0, 60.0}) {
        const double cosine = std::cos(radians(t)), sine = std::sin(radians(t));
        expect(wall_light({polarizer(t), polarizer(0)}, Plane::s0), bare * 0.5 * cosine * cosine);
        expect(wall_light({polarizer(90), polarizer(t), polarizer(0)}, Plane::s0),
               bare * 0.5 * cosine * cosine * sine * sine);
    }
    expect(wall_light({polarizer(90), polarizer(0)}, Plane::s0), 0);
    expect(wall_light({polarizer(90), polarizer(0)}, Plane::unpolarized), bare * 0.25);
}

}  // namespace
}  // namespace brewster
