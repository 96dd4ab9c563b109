#include <gtest/gtest.h>

#include "optics/random_light.h"
#include "reference/camera_tracer.h"
#include "reference/hand_made.h"
#include "reference/path_flux.h"
#include "reference/reference.h"
#include "reference/samples.h"
#include "reference/two_mirrors.h"
#include "scene/test_materials.h"

/// The reference against answers in closed form (theory 6). Every statistical bound is 3.5 standard errors of the
/// reference itself (probability 5e-4 each) and what is said beside it for facets that stand in for curves.
namespace brewster {
namespace {

constexpr double errors_allowed = 3.5;

/// Means of the Stokes components over a picture.
struct Seen {
    std::array<double, 4> mean, error;
};

Seen render(const Scene& scene, const Camera& camera, int side, std::uint64_t samples, bool polarized = true) {
    Reference reference(scene, camera, side, side, polarized, 1, threads);
    reference.add_samples(scaled(samples));
    const Image picture = reference.picture();
    Seen seen;
    for (int j = 0; j < 4; ++j) {
        const PictureMean mean = mean_of(picture, j, 0);
        seen.mean[static_cast<std::size_t>(j)] = mean.mean;
        seen.error[static_cast<std::size_t>(j)] = mean.standard_error;
    }
    return seen;
}

void expect_close(const char* what, double value, double expected, double error, double facets = 0) {
    std::printf("%-34s %.6f against %.6f: %+.3f %% +- %.3f %%\n", what, value, expected, 100 * (value / expected - 1),
                100 * error / expected);
    EXPECT_NEAR(value, expected, errors_allowed * error + facets * expected) << what;
}

/// Emission 1, albedo .5: radiance 2 everywhere (scene_checks: furnace_radiosity).
TEST(ClosedAnswers, Furnace) {
    const Scene scene = read_scene(std::string(BREWSTER_SOURCE_DIR) + "/assets/scenes/furnace.gltf");
    const Seen seen = render(scene, scene.cameras.front(), 32, 120);
    expect_close("furnace", seen.mean[0], 2, seen.error[0]);
    EXPECT_NEAR(seen.mean[1], 0, 1e-12);
    if (light_test_scale == 1) {
        EXPECT_LT(seen.error[0], 0.002);
        EXPECT_GT(std::abs(2.02 - seen.mean[0]), errors_allowed * seen.error[0]);  // 1 % would be noticed
    }
}

/// Flux from one surface to another over what is emitted, form_factors.json.
TEST(ClosedAnswers, FormFactors) {
    const auto factor = [](const char* what, HandMade& room, double expected, double facets) {
        const auto scene = room.finish();
        const Surroundings surroundings(*scene);
        const PathFlux flux = path_flux(surroundings, {"to"}, scaled(1000000), 1, threads);
        const double power = static_cast<double>(scene->lamps.front().power.x);
        expect_close(what, flux.unpolarized.mean[0] / power, expected, flux.unpolarized.standard_error[0] / power,
                     facets);
    };
    {
        HandMade room;
        const auto lamp = room.add(emitter(glm::vec3(1.0f))), wall = room.add(grey(0.5f));
        room.polygon("from", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, lamp);
        room.polygon("to", {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, wall);
        factor("parallel squares", room, 0.19982489569838738, 0);
    }
    {
        HandMade room;
        const auto lamp = room.add(emitter(glm::vec3(1.0f))), wall = room.add(grey(0.5f));
        room.polygon("from", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, lamp);  // w = 2 by l = 1
        room.polygon("to", {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, wall);    // h = 1, faces +x
        factor("perpendicular rectangles", room, 0.11642630139768094, 0);
    }
    {
        // Polygons of 256 corners on circles: the areas fall short by (2 pi/256)^2/6 = 1e-4.
        HandMade room;
        const auto lamp = room.add(emitter(glm::vec3(1.0f))), wall = room.add(grey(0.5f));
        const auto disk = [](double radius, double z, bool up) {
            std::vector<glm::vec3> outline;
            for (int k = 0; k < 256; ++k) {
                const double t = 2 * pi * (up ? k : -k) / 256;
                outline.emplace_back(radius * std::cos(t), radius * std::sin(t), z);
            }
            return outline;
        };
        room.polygon("from", disk(1, 0, true), lamp);
        room.polygon("to", disk(2, 1, false), wall);
        factor("coaxial disks", room, 0.76393202250021030, 1e-4);
    }
}

/// Any emitter in a closed sphere: rho Phi/(A (1 - rho)) of indirect radiosity, in the mean over the area A for any
/// shape, at every point of a sphere. The point lamp's own light is Phi/(4 pi) cos/d^2, 1/(1 - rho) of both together.
/// 96 x 48 facets: their distances differ from the radius by less than (pi/96)^2/2 = 5e-4, their light by 1e-3.
TEST(ClosedAnswers, IntegratingSphere) {
    HandMade room;
    const auto wall = room.add(grey(0.8f));
    room.sphere("wall", glm::dvec3(0.0), 1, 48, true, wall);
    Lamp lamp;
    lamp.kind = LampKind::point;
    lamp.intensity = glm::vec3(1.0f);
    lamp.power = point_power(lamp.intensity);
    room.lamp(lamp);
    const auto scene = room.finish();
    const Seen seen = render(*scene, looking({0.1, 0.05, 0.5}, {0, 0, -1}, 60), 32, 200);
    // Radiosity over pi: direct rho E/pi = .8/pi and indirect .8 x 4 pi/(4 pi x .2)/pi = ... in all rho/(1 - rho)/pi.
    expect_close("integrating sphere", seen.mean[0], 0.8 / 0.2 / pi, seen.error[0], 1.5e-3);
}

/// r = 1 and 2, rho .5 and .7, the inner one emits 1 (radiosity): scene_checks sphere_in_sphere. Both of one
/// tessellation, so the areas' ratio, which alone counts, is exact; uneven facets within 1e-3.
TEST(ClosedAnswers, ConcentricSpheres) {
    HandMade room;
    const auto inner = room.add(emitter(glm::vec3(static_cast<float>(1 / pi)), glm::vec3(0.5f)));
    const auto outer = room.add(grey(0.7f));
    room.sphere("inner", glm::dvec3(0.0), 1, 32, false, inner);
    room.sphere("outer", glm::dvec3(0.0), 2, 32, true, outer);
    const auto scene = room.finish();
    const Seen inside = render(*scene, looking({0, 0, 1.6}, {0, 0, 0}, 40), 24, 100);
    const Seen outside = render(*scene, looking({0, 0, 1.4}, {0, 0.3, 2}, 60), 24, 200);
    expect_close("inner of two spheres", inside.mean[0] * pi, 1.2258064516129032, inside.error[0] * pi, 1e-3);
    expect_close("outer of two spheres", outside.mean[0] * pi, 0.45161290322580638, outside.error[0] * pi, 1e-3);
}

/// What the camera sees of them through a narrow view.
Seen seen_in_two_mirrors(double n, double theta, double psi, bool polarized) {
    const TwoMirrors mirrors = two_mirrors(n, theta, psi);
    return render(*mirrors.scene, mirrors.camera, 4, 2, polarized);
}

/// scene_checks.json, two_equal_reflections and double_brewster: no randomness is left, float coordinates are (1e-5).
TEST(ClosedAnswers, TwoReflections) {
    const double brewster = std::atan(1.5);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, radians(30), 0, true).mean[0], 1.9889546006017059e-3, 2e-8);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, radians(30), radians(45), true).mean[0], 1.7241284679279697e-3, 2e-8);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, radians(60), radians(45), true).mean[0], 7.9542697404643855e-3, 8e-8);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, radians(60), radians(90), true).mean[0], 3.1817078961857542e-4, 2e-8);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, brewster, 0, true).mean[0], 0.010941493645180491, 1e-7);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, brewster, radians(90), true).mean[0], 0, 1e-8);
    EXPECT_NEAR(seen_in_two_mirrors(1.5, brewster, radians(90), false).mean[0], 5.4707468225902454e-3, 1e-7);
    EXPECT_NEAR(seen_in_two_mirrors(10, std::atan(10.0), radians(90), false).mean[0], 0.23077847114965471, 1e-5);
    EXPECT_NEAR(seen_in_two_mirrors(10, std::atan(10.0), std::acos(0.01), true).mean[0], 4.6155694229930942e-5, 1e-7);
}

/// Between parallel faces (theory 6): after N reflections DoP = (Rs^N - Rp^N)/(Rs^N + Rp^N), polarized along s.
TEST(ClosedAnswers, ParallelMirrors) {
    HandMade room;
    const auto mirror = room.add(test_materials::dielectric(Base::black));
    const auto lamp = room.add(emitter(glm::vec3(1.0f)));
    room.polygon("below", {{-1, -1, 0}, {7, -1, 0}, {7, 1, 0}, {-1, 1, 0}}, mirror);
    room.polygon("above", {{-0.5, -1, 1}, {-0.5, 1, 1}, {7, 1, 1}, {7, -1, 1}}, mirror);
    const double theta = radians(60), step = std::tan(theta);
    // Down at x = 0, up at step, down at 2 step, which is the third reflection; the lamp ends the way up. With a fourth
    // the roulette would begin.
    room.square("lamp", {2.5 * step, 0, 0.5}, {-1, 0, 0}, 0.4, lamp);
    const auto scene = room.finish();
    const Camera camera = looking({-std::tan(theta) * 2, 0, 2}, glm::dvec3(0.0), 0.01);
    const Seen seen = render(*scene, camera, 4, 2);
    const auto at = dielectric_interface(std::cos(theta), 1.5);
    const double s = std::pow(at.Rs, 3), p = std::pow(at.Rp, 3);
    EXPECT_NEAR(seen.mean[0], 0.5 * (s + p), 1e-5 * s);
    // The plane of incidence lies level in the picture, so that s is upright there.
    EXPECT_NEAR(seen.mean[1] / seen.mean[0], -(s - p) / (s + p), 1e-4);
}

/// A pile of five plates met at Brewster's angle, all reflections between and inside them: scene_checks
/// pile_of_plates_brewster_T and _DoP. They are so wide that light which goes to and fro leaves them no sooner than after
/// a hundred reflections. What passes is polarized along p, upright in this picture.
TEST(ClosedAnswers, PileOfPlates) {
    HandMade room;
    const auto plate = room.add(test_materials::pane()), lamp = room.add(emitter(glm::vec3(1.0f)));
    for (int k = 0; k < 5; ++k) room.square("plate " + std::to_string(k), {0, 0, -0.01 * k}, {0, 0, 1}, 1, plate);
    room.square("lamp", {0, 0, -0.1}, {0, 0, 1}, 1, lamp);
    const double theta = std::atan(1.5);
    const Camera camera = looking({0, -2 * std::sin(theta), 2 * std::cos(theta)}, glm::dvec3(0.0), 0.1);
    const Seen seen = render(*room.finish(), camera, 8, 500);
    expect_close("pile of plates", seen.mean[0], 0.682741116751269, seen.error[0]);
    expect_close("pile of plates, polarized part", -seen.mean[1], 0.682741116751269 * 0.4646840148698885,
                 seen.error[1]);
    EXPECT_NEAR(seen.mean[2], 0, errors_allowed * seen.error[2] + 1e-6);
}

/// A furnace of radiance 1 stays 1 and unpolarized, whatever lossless thing stands in it, polarization on or off: a
/// glass body, a pane, white plastic smooth and rough (theory 3.9, 6).
TEST(ClosedAnswers, LosslessThingsAreInvisibleInAFurnace) {
    std::vector<std::pair<const char*, Material>> things;
    Material glass = test_materials::dielectric(Base::transparent);
    Material white = test_materials::dielectric(Base::polarized_diffuse);
    white.albedo = glm::vec3(1.0f);
    things.emplace_back("glass in a furnace", glass);
    things.emplace_back("smooth plastic in a furnace", white);
    things.emplace_back("rough plastic in a furnace", test_materials::beckmann(white, 0.4f));
    things.emplace_back("Kirchhoff plastic in a furnace", test_materials::kirchhoff(white, 0.1f, 1.5f));
    for (const auto& [name, material] : things)
        for (const bool polarized : {true, false}) {
            HandMade room;
            const auto wall = room.add(emitter(glm::vec3(1.0f)));
            const auto thing = room.add(material);
            room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, wall);
            room.box("thing", {-0.5f, -0.4f, -0.6f}, {0.5f, 0.6f, 0.4f}, false, thing);
            const auto scene = room.finish();
            const Seen seen = render(*scene, looking({1.2, 0.9, 1.5}, glm::dvec3(0.0), 40), 24, 60, polarized);
            expect_close(name, seen.mean[0], 1, seen.error[0] + 1e-9);
            EXPECT_NEAR(seen.mean[1], 0, errors_allowed * seen.error[1] + 1e-9) << name;
            EXPECT_NEAR(seen.mean[2], 0, errors_allowed * seen.error[2] + 1e-9) << name;
        }
    HandMade room;
    const auto wall = room.add(emitter(glm::vec3(1.0f))), pane = room.add(test_materials::pane());
    room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, wall);
    room.square("pane", {0, 0, 0}, {1, 0.3, 1}, 0.6, pane);
    const Seen seen = render(*room.finish(), looking({1.2, 0.9, 1.5}, glm::dvec3(0.0), 30), 24, 60);
    expect_close("pane in a furnace", seen.mean[0], 1, seen.error[0] + 1e-9);
    EXPECT_NEAR(seen.mean[1], 0, errors_allowed * seen.error[1] + 1e-9);
}

/// Sun, point and spot on a Lambert floor: E rho/pi, with E = lux cos; I cos/d^2.
TEST(ClosedAnswers, LampsWithoutExtent) {
    const auto floor_under = [](Lamp lamp, double expected, const char* what) {
        HandMade room;
        const auto floor = room.add(grey(0.5f));
        room.square("floor", {0, 0, 0}, {0, 0, 1}, 5, floor);
        room.lamp(lamp);
        const auto scene = room.finish();
        const Seen seen = render(*scene, looking({0, -3, 3}, {0, 0, 0}, 0.02), 4, 200);
        expect_close(what, seen.mean[0], expected, seen.error[0] + 1e-4 * expected);
    };
    floor_under(slanting_sun(), 4 * std::sqrt(0.5) * 0.5 / pi, "sun");
    // Of a disc above the horizon the irradiance on a tilted surface is that of its middle: E cos.
    floor_under(slanting_sun(0.2f), 4 * std::sqrt(0.5) * 0.5 / pi, "sun's disc");
    floor_under(spot_above(), 3.0 / 4 * 0.5 / pi, "spot");
}

}  // namespace
}  // namespace brewster
