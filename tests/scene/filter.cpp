#include <gtest/gtest.h>

#include <cmath>

#include "optics/mueller.h"
#include "scene/bsdf.h"
#include "scene/filter_axis.h"
#include "scene/gltf_builder.h"
#include "scene/scene.h"
#include "scene/test_materials.h"

namespace brewster {
namespace {

using Light = Stokes<double, 4>;
const Vector<double> sheet_normal{0, 0, 1};
constexpr double quarter_turn = 0.5 * pi;

/// What a sheet does to light that comes straight down, in the frame x that both segments share.
template <Use use = Use::light>
Light through(const Material& material, double angle, const Light& light) {
    const PreparedMaterial sheet = prepare_materials({material})[0];
    const SurfacePoint<double> at{sheet_normal, {1, 0, 0}, sheet_normal, false, {std::cos(angle), std::sin(angle), 0}};
    const auto sample = sample_bsdf<use, 1>(sheet, at, {});
    EXPECT_TRUE(sample.alive && sample.sharp && sample.refracted && !sample.base);
    EXPECT_EQ(sample.direction.z, -1);
    // Light that runs down, or, for the eye that looks down, up.
    const Vector<double> direction = use == Use::light ? -sheet_normal : sheet_normal;
    const Light in = use == Use::light ? rotate(sample.turn, light)
                                       : rotate(rotation_between(direction, {1, 0, 0}, sample.axis), light);
    const Light out = sample.weight[0] * in;
    return use == Use::light ? rotate(rotation_between(direction, sample.axis, {1, 0, 0}), out)
                             : rotate(sample.turn, out);
}

Mueller<double> plate_matrix() {
    const auto retardance = static_cast<double>(1.1f);
    return elements::retarder_fast_x(std::cos(retardance), std::sin(retardance));
}

// theory 1.3, turned by the angle as the receiver below sees it: from there, +angle about +z runs clockwise.
TEST(Filter, SheetsHaveTheirMuellerMatrices) {
    for (const double angle : {0.0, 0.4, 1.2, 2.9})
        for (const Light& light : {Light{{1, 0.3, -0.5, 0.7}}, Light{{1, 0, 0, 0}}, Light{{1, 0, 1, 0}}}) {
            const Light polarized = through(test_materials::filter(FilterKind::polarizer, 0), angle, light);
            const Light expected = rotated(elements::polarizer<double>(), turn_by(-angle)) * light;
            const Light delayed =
                through(test_materials::filter(FilterKind::retarder, 0, glm::vec3(1.1f)), angle, light);
            const Light expected_delayed = rotated(plate_matrix(), turn_by(-angle)) * light;
            for (int j = 0; j < 4; ++j) {
                EXPECT_NEAR(polarized[j], expected[j], 1e-12);
                EXPECT_NEAR(delayed[j], expected_delayed[j], 1e-7);
            }
        }
}

// A sheet between a lamp and an eye is one thing, whichever end a path begins at.
TEST(Filter, TheEyeSeesWhatTheLightDoes) {
    const Material plate = test_materials::filter(FilterKind::retarder, 0, glm::vec3(1.1f));
    const Light light{{1, 0.3, -0.5, 0.7}};
    const Light seen = through<Use::eye>(plate, 0.4, light);
    const Light expected = rotated(plate_matrix(), turn_by(0.4)) * light;  // the light runs upwards
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(seen[j], expected[j], 1e-7);
}

// Linear light at +45 degrees from the fast axis becomes left circular, S3 < 0; the half-wave plate mirrors it.
TEST(Filter, QuarterAndHalfWavePlates) {
    const auto plate = [](double retardance) {
        return test_materials::filter(FilterKind::retarder, 0, glm::vec3(static_cast<float>(retardance)));
    };
    EXPECT_NEAR(through(plate(quarter_turn), 0, {{1, 0, 1, 0}}).s3(), -1, 1e-6);
    EXPECT_NEAR(through(plate(2 * quarter_turn), 0, {{1, 0, 1, 0}}).s2(), -1, 1e-6);
}

// Under oblique light the axis is that of the sheet less its part along the light: two sheets whose axes cross on the
// sheet let through what the geometry of their projections says.
TEST(Filter, ObliqueAxesAreProjected) {
    const PreparedMaterial sheet = prepare_materials({test_materials::filter(FilterKind::polarizer, 0)})[0];
    const Vector<double> towards = normalized(Vector<double>{0.8, 0.3, 0.5});
    const auto axis_of = [&](const Vector<double>& on_sheet) {
        const SurfacePoint<double> at{towards, normalized(cross(towards, sheet_normal)), sheet_normal, false, on_sheet};
        return sample_bsdf<Use::light, 1>(sheet, at, {}).axis;
    };
    const Vector<double> x{1, 0, 0}, y{0, 1, 0};
    for (const Vector<double>& on_sheet : {x, y}) {
        const Vector<double> projected = normalized(on_sheet - dot(on_sheet, towards) * towards);
        EXPECT_NEAR(std::abs(dot(axis_of(on_sheet), projected)), 1, 1e-12);
    }
    EXPECT_GT(std::abs(dot(axis_of(x), axis_of(y))), 0.1);
}

// The angle counts from the node's x axis, counter-clockwise seen from the front, for both sides alike.
TEST(Filter, AnglesTurnWithTheNode) {
    GltfBuilder file;
    const int material = file.add_material("sheet", {1, 1, 1});
    file.json["materials"][0]["extensions"]["BREWSTER_surface"] = {{"polarizer", {{"angle", 30}}}};
    const int node = file.add_polygon("sheet", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, material);
    file.json["nodes"][static_cast<std::size_t>(node)]["rotation"] = {0, 0, std::sin(pi / 8), std::cos(pi / 8)};
    const Scene scene = read_scene_text(file.text(), "test");
    ASSERT_EQ(scene.charts.size(), 2u);
    const PreparedMaterial sheet = prepare_materials(scene.materials)[0];
    for (const Chart& chart : scene.charts) {
        const Vector<double> axis = filter_axis(sheet, chart);
        EXPECT_NEAR(axis.x, std::cos(75 * pi / 180), 1e-6);
        EXPECT_NEAR(axis.y, std::sin(75 * pi / 180), 1e-6);
    }
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

}  // namespace
}  // namespace brewster
