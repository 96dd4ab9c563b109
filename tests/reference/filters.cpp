#include <gtest/gtest.h>

#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "reference/reference.h"
#include "reference/samples.h"
#include "scene/test_materials.h"

/// Polarizers and retarders in closed form (theory 1.3, 6), for light that is met through them and that they let pass
/// onto things. Sheets are squares that face the eye; their angles count from x, which lies level.
namespace brewster {
namespace {

Material polarizer(double degrees) {
    return test_materials::filter(FilterKind::polarizer, static_cast<float>(radians(degrees)));
}

struct SeenBands {
    std::array<std::array<double, 4>, band_count> mean, error;
};

SeenBands render(const Scene& scene, const Camera& camera, std::uint64_t samples, bool polarized = true) {
    Reference reference(scene, camera, 4, 4, polarized, 1, threads);
    reference.add_samples(samples);
    const Image picture = reference.picture();
    SeenBands seen;
    for (int band = 0; band < band_count; ++band)
        for (int j = 0; j < 4; ++j) {
            const PictureMean mean = mean_of(picture, j, band);
            seen.mean[static_cast<std::size_t>(band)][static_cast<std::size_t>(j)] = mean.mean;
            seen.error[static_cast<std::size_t>(band)][static_cast<std::size_t>(j)] = mean.standard_error;
        }
    return seen;
}

/// A lamp of radiance 1 straight ahead, behind sheets; the first is met first by the light. Nothing is left to chance.
SeenBands lamp_behind(const std::vector<Material>& sheets, bool polarized = true, std::uint64_t samples = 2) {
    HandMade room;
    const auto lamp = room.add(emitter(glm::vec3(1.0f)));
    room.square("lamp", {0, 0, -5}, {0, 0, 1}, 1, lamp);
    double z = -4;
    for (const Material& sheet : sheets) {
        z += 0.5;
        room.square("sheet " + std::to_string(z), {0, 0, z}, {0, 0, 1}, 1, room.add(sheet));
    }
    return render(*room.finish(), looking({0, 0, 3}, {0, 0, 0}, 0.1), samples, polarized);
}

TEST(Filters, Malus) {
    for (const double angle : {0.0, 25.0, -60.0, 90.0}) {
        const SeenBands seen = lamp_behind({polarizer(10), polarizer(10 + angle)});
        const double expected = 0.5 * std::pow(std::cos(radians(angle)), 2);
        EXPECT_NEAR(seen.mean[0][0], expected, 1e-6) << angle;
        // What leaves is polarized along the last one's axis.
        EXPECT_NEAR(seen.mean[0][1], expected * std::cos(2 * radians(10 + angle)), 1e-6) << angle;
        EXPECT_NEAR(seen.mean[0][2], expected * std::sin(2 * radians(10 + angle)), 1e-6) << angle;
        EXPECT_NEAR(lamp_behind({polarizer(10), polarizer(10 + angle)}, false).mean[0][0], 0.25, 1e-6);
    }
}

TEST(Filters, AThirdBetweenCrossedPolarizers) {
    EXPECT_NEAR(lamp_behind({polarizer(0), polarizer(90)}).mean[1][0], 0, 1e-9);
    const double t = radians(30);
    EXPECT_NEAR(lamp_behind({polarizer(0), polarizer(30), polarizer(90)}).mean[1][0],
                0.5 * std::pow(std::cos(t) * std::sin(t), 2), 1e-6);
}

/// Crossed 1/2 sin^2 2b sin^2 G/2, each band by its own G; alone, a quarter-wave plate with its fast axis level turns
/// light at 45 degrees into S3 = -S2 (theory 1.3).
TEST(Filters, Waveplates) {
    const glm::vec3 retardance(1.5f, 1.9f, 2.8f);
    const double b = radians(35);
    const Material plate = test_materials::filter(FilterKind::retarder, static_cast<float>(b), retardance);
    const SeenBands crossed = lamp_behind({polarizer(0), plate, polarizer(90)});
    for (std::size_t band = 0; band < band_count; ++band) {
        const double half = 0.5 * static_cast<double>(retardance[static_cast<int>(band)]);
        EXPECT_NEAR(crossed.mean[band][0], 0.5 * std::pow(std::sin(2 * b) * std::sin(half), 2), 1e-6) << band;
    }
    const Material quarter = test_materials::filter(FilterKind::retarder, 0, glm::vec3(static_cast<float>(0.5 * pi)));
    const SeenBands circular = lamp_behind({polarizer(45), quarter});
    EXPECT_NEAR(circular.mean[0][2], 0, 1e-6);
    EXPECT_NEAR(circular.mean[0][3], -0.5, 1e-6);
}

/// A pane met straight on passes (1 - R)/(1 + R), R = ((n - 1)/(n + 1))^2; whether a path is mirrored is left to chance.
TEST(Filters, AndPanes) {
    const SeenBands seen = lamp_behind({test_materials::pane(), polarizer(20)}, true, 1000);
    EXPECT_NEAR(seen.mean[0][0], 0.5 * 0.96 / 1.04, 4 * seen.error[0][0]);
    EXPECT_LT(seen.error[0][0], 0.002);
}

/// A sun through a polarizer onto a white floor, which depolarizes, seen through another or a pane: E/2 rho/pi times what
/// that passes. No path from the camera finds this sun: it is the light tracer that looks through the sheets.
TEST(Filters, FloorsLitAndSeenThroughSheets) {
    const auto floor_seen_through = [](const Material* sheet, bool polarized) {
        HandMade room;
        const auto floor = room.add(grey(0.6f)), above = room.add(polarizer(20));
        room.square("floor", {0, 0, 0}, {0, 0, 1}, 0.5, floor);
        room.square("above", {0, 0, 2}, {0, 0, 1}, 0.5, above);
        // Across the eye's way, which comes from -y at 45 degrees.
        if (sheet) room.square("sheet", {0, -0.7, 0.7}, {0, -1, 1}, 0.3, room.add(*sheet));
        Lamp sun;
        sun.kind = LampKind::sun;
        sun.intensity = glm::vec3(5.0f);
        sun.direction = {0, 0, -1};
        room.lamp(sun);
        const std::uint64_t samples = scaled(4000);
        Camera camera = looking({0, -1, 1}, {0, 0, 0}, 20);
        camera.up = glm::normalize(glm::vec3(0, 1, 1));
        return render(*room.finish(), camera, samples, polarized);
    };
    const double radiance = 0.5 * 5 * 0.6 / pi;
    const auto expect = [&](const SeenBands& seen, std::size_t component, double expected, const char* what) {
        const double error = seen.error[0][component];
        std::printf("%-28s S%zu %+.5f against %+.5f +- %.5f\n", what, component, seen.mean[0][component], expected,
                    error);
        EXPECT_NEAR(seen.mean[0][component], expected, 4 * error + 1e-4) << what;
        if (light_test_scale == 1) {
            EXPECT_LT(error, 0.02 * radiance);
        }
    };
    expect(floor_seen_through(nullptr, true), 0, radiance, "seen freely");
    const Material second = polarizer(30);
    const SeenBands through = floor_seen_through(&second, true);
    expect(through, 0, radiance / 2, "through a polarizer");
    expect(through, 1, radiance / 2 * std::cos(radians(60)), "through a polarizer");
    expect(through, 2, radiance / 2 * std::sin(radians(60)), "through a polarizer");
    expect(floor_seen_through(&second, false), 0, radiance / 2, "without polarization");
    const Material pane = test_materials::pane();
    expect(floor_seen_through(&pane, true), 0, radiance * 0.96 / 1.04, "through a pane");
}

/// At Brewster's angle only s is reflected: a polarizer across the plane of incidence passes the glare, one along it
/// nothing; the p side, Rp, is zero there.
TEST(Filters, PolarizersTakeTheGlareOffGlass) {
    const auto glare = [](double degrees) {
        HandMade room;
        const auto lamp = room.add(emitter(glm::vec3(1.0f)));
        const auto glass = room.add(test_materials::dielectric(Base::black));
        const double theta = std::atan(1.5);
        const glm::dvec3 down(std::sin(theta), 0, -std::cos(theta)), up(std::sin(theta), 0, std::cos(theta));
        room.square("glass", {0, 0, 0}, {0, 0, 1}, 0.5, glass);
        room.square("lamp", 3.0 * up, -up, 1, lamp);
        // Faces the eye; x of the scene, put into the sheet's plane, lies in the plane of incidence.
        room.square("sheet", -0.8 * down, -down, 0.4, room.add(polarizer(degrees)));
        return render(*room.finish(), looking(-2.0 * down, {0, 0, 0}, 0.1), 2).mean[0][0];
    };
    const auto at = dielectric_interface(std::cos(std::atan(1.5)), 1.5);
    EXPECT_NEAR(glare(90), 0.5 * at.Rs, 1e-5);
    EXPECT_NEAR(glare(0), 0, 1e-6);
    EXPECT_NEAR(glare(45), 0.25 * at.Rs, 1e-5);
}

}  // namespace
}  // namespace brewster
