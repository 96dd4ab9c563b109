#include <gtest/gtest.h>

#include "gather/gather_test.h"
#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "reference/two_mirrors.h"
#include "scene/bsdf.h"
#include "scene/test_materials.h"
#include "scene/vectors.h"

/// Gathered pictures against answers in closed form (theory 1.3, 2, 5, 6). Statistical bounds are 3.5 standard errors
/// that the picture itself states (probability 5e-4 each).
namespace brewster {
namespace {

constexpr double errors_allowed = 3.5;
constexpr std::array<Plane, 3> polarized_planes = {Plane::s1, Plane::s2, Plane::s3};

std::uint32_t scaled(std::uint32_t draws) {
    return std::max(draws / static_cast<std::uint32_t>(light_test_scale), 1u);
}

/// Through a view so narrow that no randomness is left.
StokesPicture look_straight(const std::shared_ptr<const Scene>& scene, const Camera& camera) {
    return gathered(scene, even_bins(*scene, 0, 0), camera, 2, 2, 4);
}

double first_value(const StokesPicture& picture, Plane plane) {
    return static_cast<double>(picture.of(plane)[0].x);
}

/// theory 2.7: S0 = A1 A2 + B1 B2 cos 2 psi, without polarization A1 A2. Float directions: 1e-4 of the whole light.
TEST(GatherClosedAnswers, TwoReflections) {
    for (const double n : {1.5, 10.0})
        for (const double theta : {radians(30), std::atan(n)})
            for (const double psi : {0.0, radians(45), radians(90)}) {
                const auto at = dielectric_interface(std::cos(theta), n);
                const double a = at.reflection.a, b = at.reflection.b;
                const TwoMirrors mirrors = two_mirrors(n, theta, psi);
                const StokesPicture picture = look_straight(mirrors.scene, mirrors.camera);
                EXPECT_NEAR(first_value(picture, Plane::s0), a * a + b * b * std::cos(2 * psi), 1e-4 * a * a);
                EXPECT_NEAR(first_value(picture, Plane::unpolarized), a * a, 1e-4 * a * a);
            }
}

/// A pane and both faces of a glass body straight ahead pass what they do not reflect, whatever the index inside: the
/// radiance factor 1/n^2 of one face is undone by the other. Weaker ways are drawn now and then, so the mean is statistical.
TEST(GatherClosedAnswers, PaneAndGlassPassWhatTheyDoNotReflect) {
    const double r = 0.04;  // ((1.5 - 1)/(1.5 + 1))^2
    for (const bool body : {false, true}) {
        HandMade room;
        const auto lamp = room.add(emitter(glm::vec3(1.0f)));
        room.square("lamp", {0, 0, -3}, {0, 0, 1}, 2, lamp);
        if (body)
            room.box("glass", {-0.5f, -0.5f, -1.5f}, {0.5f, 0.5f, -1}, false,
                     room.add(test_materials::dielectric(Base::transparent)));
        else
            room.square("pane", {0, 0, -1}, {0, 0, 1}, 0.5, room.add(test_materials::pane()));
        const auto scene = room.finish();
        const StokesPicture picture =
            gathered(scene, even_bins(*scene, 0, 0), looking({0, 0, 1}, {0, 0, -1}, 5), 16, 16, scaled(1024));
        // Both add up the light's reflections between the faces: (1 - r)/(1 + r).
        const PlaneMean seen = mean_of(picture, Plane::s0);
        EXPECT_NEAR(seen.mean, (1 - r) / (1 + r), errors_allowed * seen.error + 2e-4) << body;
        if (light_test_scale == 1) {
            EXPECT_LT(seen.error, 1e-3);
        }
    }
}

/// Filters one behind the other between the camera and a lamp, at these angles to the picture's horizontal.
StokesPicture through_filters(const std::vector<Material>& filters) {
    HandMade room;
    const auto lamp = room.add(emitter(glm::vec3(1.0f)));
    room.square("lamp", {0, 0, -9}, {0, 0, 1}, 2, lamp);
    for (std::size_t k = 0; k < filters.size(); ++k)
        room.square("filter", {0, 0, -1 - static_cast<double>(k)}, {0, 0, 1}, 0.5, room.add(filters[k]));
    return look_straight(room.finish(), looking({0, 0, 1}, {0, 0, -1}, 0.01));
}

/// Malus with a third polarizer between crossed ones, 1/2 cos^2 t sin^2 t (theory 6); without polarization each passes
/// half. A quarter-wave plate behind a polarizer at 45 degrees to its fast axis makes circular light.
TEST(GatherClosedAnswers, Filters) {
    using test_materials::filter;
    const auto polarizer = [](double degrees) {
        return filter(FilterKind::polarizer, static_cast<float>(radians(degrees)));
    };
    const StokesPicture malus = through_filters({polarizer(20), polarizer(80)});
    EXPECT_NEAR(first_value(malus, Plane::s0), 0.5 * std::pow(std::cos(radians(60)), 2), 1e-5);
    EXPECT_NEAR(first_value(malus, Plane::unpolarized), 0.25, 1e-5);
    const StokesPicture third = through_filters({polarizer(0), polarizer(30), polarizer(90)});
    EXPECT_NEAR(first_value(third, Plane::s0), 0.5 * std::pow(std::cos(radians(30)) * std::sin(radians(30)), 2), 1e-5);
    // The sheet's axes stand level in the picture: seen through one at 20 degrees, light lies along 20 degrees.
    EXPECT_NEAR(first_value(malus, Plane::s1), 0.125 * std::cos(radians(40)), 1e-5);
    EXPECT_NEAR(first_value(malus, Plane::s2), 0.125 * std::sin(radians(40)), 1e-5);
    // Fast axis x under light along +45 degrees: (S2, S3) = (cos G, -sin G) S2 (theory 1.3).
    const auto plate = filter(FilterKind::retarder, 0.0f, glm::vec3(static_cast<float>(radians(90))));
    const StokesPicture circular = through_filters({plate, polarizer(45)});
    EXPECT_NEAR(first_value(circular, Plane::s3), -0.5, 1e-5);
    EXPECT_NEAR(first_value(circular, Plane::s2), 0, 1e-5);
}

/// A furnace of radiance 1 stays 1 and unpolarized in both worlds, whatever lossless thing stands in it (theory 3.9, 6).
/// Its bins hold what enters the base, pi (1 - Fe), as direct light, which only lobe rays may read. The lamps are all
/// around, so lobe rays and lamp points share every direction.
TEST(GatherClosedAnswers, LosslessThingsAreInvisibleInAFurnace) {
    std::vector<Material> things;
    Material white = test_materials::dielectric(Base::polarized_diffuse);
    white.albedo = glm::vec3(1.0f);
    things.push_back(test_materials::named(test_materials::dielectric(Base::transparent), "glass"));
    things.push_back(test_materials::named(white, "smooth plastic"));
    things.push_back(test_materials::named(test_materials::beckmann(white, 0.4f), "rough plastic"));
    things.push_back(test_materials::named(test_materials::kirchhoff(white, 0.1f, 1.5f), "Kirchhoff plastic"));
    for (const Material& material : things) {
        HandMade room;
        const auto wall = room.add(emitter(glm::vec3(1.0f)));
        const auto thing = room.add(material);
        room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, wall);
        room.box("thing", {-0.5f, -0.4f, -0.6f}, {0.5f, 0.6f, 0.4f}, false, thing);
        const auto scene = room.finish();
        const StokesPicture picture = gathered(scene, even_bins(*scene, 100, 0),
                                               looking({1.2, 0.9, 1.5}, glm::dvec3(0.0), 40), 24, 24, scaled(256));
        for (const Plane plane : {Plane::s0, Plane::unpolarized}) {
            const PlaneMean seen = mean_of(picture, plane);
            EXPECT_NEAR(seen.mean, 1, errors_allowed * seen.error + 1e-6) << material.name;
            if (light_test_scale == 1) {
                EXPECT_LT(seen.error, 2.5e-3) << material.name;  // 1 % would be noticed
            }
        }
        for (const Plane plane : polarized_planes) {
            const PlaneMean seen = mean_of(picture, plane);
            EXPECT_NEAR(seen.mean, 0, errors_allowed * seen.error + 1e-6) << material.name;
        }
    }
}

/// The same where the base's light comes from the bins: a lamp far off in a corner of the walls leaves them black, and
/// evenly lit Lambert walls of radiosity pi stand for the furnace. A rough thing sees walls by its lobe and their bins.
TEST(GatherClosedAnswers, LobesEndInTheBins) {
    Material white = test_materials::beckmann(test_materials::dielectric(Base::polarized_diffuse), 0.4f);
    white.albedo = glm::vec3(1.0f);
    HandMade room;
    const auto wall = room.add(grey(0.5f)), thing = room.add(white);
    room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, wall);
    room.box("thing", {-0.5f, -0.4f, -0.6f}, {0.5f, 0.6f, 0.4f}, false, thing);
    room.square("lamp", {0, 0, 9}, {0, 0, 1}, 0.1, room.add(emitter(glm::vec3(1.0f))));  // sees nothing
    const auto scene = room.finish();
    const auto bins = even_bins(*scene, 0, 0);
    const RoughInterface table(1.5, 0.4);
    for (std::size_t chart = 0; chart < scene->charts.size(); ++chart) {
        // Direct and indirect light of the walls make their radiance 1 together; of the thing there is indirect only.
        const bool of_thing = scene->charts[chart].material == thing;
        const double direct = of_thing ? 0 : 1.5 * pi;
        const double indirect = of_thing ? pi * (1 - table.external_reflectance()) : 0.5 * pi;
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
            bins->leaves[8 * chart + corner] = glm::vec4(glm::vec3(static_cast<float>(direct)), 0.0f);
            bins->leaves[8 * chart + 4 + corner] = glm::vec4(glm::vec3(static_cast<float>(indirect)), 0.0f);
        }
    }
    const auto seen_at = [&](glm::dvec3 to, Plane plane) {
        return mean_of(gathered(scene, bins, looking({1.2, 0.9, 1.5}, to, 15), 16, 16, scaled(256)), plane);
    };
    const PlaneMean on_thing = seen_at(glm::dvec3(0.0), Plane::s0);
    EXPECT_NEAR(on_thing.mean, 1, errors_allowed * on_thing.error + 1e-4);
    const PlaneMean polarized = seen_at(glm::dvec3(0.0), Plane::s1);
    EXPECT_NEAR(polarized.mean, 0, errors_allowed * polarized.error + 1e-4);
    // The eye's own look takes the indirect light alone; the lamp, which shadow rays would find, lights nothing.
    EXPECT_NEAR(seen_at({-2, 2, -2}, Plane::s0).mean, 0.25, 1e-5);
}

/// E rho/pi under a sun, a disc, a spot (theory 4); under a rough face their glare is what the lobe says.
TEST(GatherClosedAnswers, LampsWithoutExtent) {
    const std::array<double, 3> lux = {4 * std::sqrt(0.5), 4 * std::sqrt(0.5), 0.75};
    for (std::size_t k = 0; k < 3; ++k) {
        const Lamp lamp = std::array{slanting_sun(), slanting_sun(0.2f), spot_above()}[k];
        for (const bool rough : {false, true}) {
            const Material gloss = test_materials::beckmann(test_materials::dielectric(Base::black), 0.3f);
            HandMade room;
            room.square("floor", {0, 0, 0}, {0, 0, 1}, 5, room.add(rough ? gloss : grey(0.5f)));
            room.lamp(lamp);
            const auto scene = room.finish();
            const glm::dvec3 eye = glm::normalize(glm::dvec3(0.6, -0.3, 1));
            const StokesPicture picture =
                gathered(scene, even_bins(*scene, 0, 0), looking(3.0 * eye, {0, 0, 0}, 0.02), 4, 4, scaled(512));
            const PlaneMean seen = mean_of(picture, Plane::unpolarized);
            double expected = lux[k] * 0.5 / pi;
            if (rough) {
                if (k == 1) continue;  // an integral, see against_reference
                const PreparedMaterial prepared = prepare_materials({gloss}).front();
                const Vector<double> towards = k == 2 ? Vector<double>{0, 0, 1} : normalized(-vector_of(lamp.direction));
                const auto value = evaluate_gloss<Use::eye, band_count>(prepared, -towards, vector_of(glm::vec3(eye)),
                                                                        Vector<double>{0, 0, 1});
                expected = lux[k] * value.value[0].m00;
            }
            EXPECT_NEAR(seen.mean, expected, errors_allowed * seen.error + 2e-4 * expected) << k << rough;
        }
    }
}

}  // namespace
}  // namespace brewster
