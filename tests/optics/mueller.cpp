#include "optics/mueller.h"

#include <gtest/gtest.h>

#include "optics/fresnel.h"
#include "random_light.h"
#include "reference_table.h"

namespace brewster {
namespace {

void compare(WorstErrors& errors, const ReferenceTable& table, std::size_t row, const std::string& label,
             const Mueller<double>& matrix) {
    const char* names[4][4] = {{"m00", "m01", "m02", "m03"},
                               {"m10", "m11", "m12", "m13"},
                               {"m20", "m21", "m22", "m23"},
                               {"m30", "m31", "m32", "m33"}};
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j) errors.absolute(label, row, matrix.m[i][j], table(row, names[i][j]));
}

TEST(Mueller, ElementsReference) {
    const ReferenceTable table("mueller_elements");
    WorstErrors errors("mueller_elements");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::string type = table.text(row, "type");
        const double p1 = table(row, "p1"), p2 = table(row, "p2");
        Mueller<double> element{};
        if (type == "polarizer") element = elements::polarizer<double>();
        if (type == "diattenuator") element = elements::diattenuator(p1, p2);
        if (type == "retarder_fast_axis") element = elements::retarder_fast_x(std::cos(p1), std::sin(p1));
        if (type == "mirror_normal") element = elements::mirror_at_normal_incidence<double>();
        if (type == "depolarizer") element = elements::depolarizer<double>();
        const auto turn = turn_by(table(row, "angle"));
        compare(errors, table, row, type, type == "frame_rotator" ? frame_matrix(turn) : rotated(element, turn));
    }
    // Absolute: elements are at most 1 and exact zeros arise as differences of rounded products.
    EXPECT_LE(errors.worst(), 1e-15);
}

TEST(Mueller, ReflectionReference) {
    const ReferenceTable table("mueller_reflection");
    WorstErrors errors("mueller_reflection");
    for (std::size_t row = 0; row < table.size(); ++row)
        compare(errors, table, row, "elements",
                mueller_reflection_from_carried_frame(mueller_reflection(table(row, "cos_theta"), table(row, "n")),
                                                      turn_by(table(row, "psi"))));
    EXPECT_LE(errors.worst(), 1e-15);
}

TEST(Mueller, MalusAndThreePolarizers) {
    const Stokes<double, 4> light = unpolarized<4>(1.0);
    const auto polarizer = elements::polarizer<double>();
    for (int degree = 0; degree <= 90; degree += 5) {
        const double t = radians(degree), c = std::cos(t), s = std::sin(t);
        const auto second = rotated(polarizer, turn_by(t));
        EXPECT_NEAR((second * polarizer * light).s0(), 0.5 * c * c, 1e-15);
        EXPECT_NEAR((rotated(polarizer, turn_by(pi / 2)) * (second * (polarizer * light))).s0(), 0.5 * c * c * s * s,
                    1e-15);
    }
}

TEST(Mueller, PlateBetweenPolarizers) {
    const auto polarizer = elements::polarizer<double>();
    const auto crossed = rotated(polarizer, turn_by(pi / 2));
    for (double wavelength : {612.0, 549.0, 465.0})
        for (double angle : {0.1, 0.7, 1.3}) {
            const double birefringence = 0.0091, thickness = 1e6;  // quartz, one millimetre
            const auto plate =
                rotated(elements::waveplate_fast_x(birefringence, thickness, wavelength), turn_by(angle));
            const double retardance = 2 * pi * birefringence * thickness / wavelength;
            const double expected = 0.5 * std::pow(std::sin(2 * angle) * std::sin(retardance / 2), 2);
            const auto in = polarizer * unpolarized<4>(1.0);
            EXPECT_NEAR((crossed * (plate * in)).s0(), expected, 1e-13);  // retardance of 123 rad carries 1e-14
            EXPECT_NEAR((polarizer * (plate * in)).s0(), 0.5 - expected, 1e-13);
        }
}

TEST(Mueller, ThickPlateKeepsItsFraction) {
    // 2^20 and a quarter waves, exact in double: a quarter-wave plate.
    const auto plate = elements::waveplate_fast_x(1.0, 1048576.25, 1.0);
    EXPECT_NEAR(plate[2][3], 1, 1e-15);
    EXPECT_NEAR(plate[2][2], 0, 1e-15);
}

TEST(Mueller, CircularPolarizersAreAPolarizerAndAPlate) {
    // A polarizer at -45 degrees, then a quarter-wave plate with fast axis x: right circular light.
    const auto train =
        elements::quarter_wave_fast_x<double>() * rotated(elements::polarizer<double>(), turn_by(-pi / 4));
    const auto light = train * unpolarized<4>(1.0);
    const auto right = elements::right_circular_polarizer<double>() * light;
    const auto left = elements::left_circular_polarizer<double>() * light;
    EXPECT_NEAR(light.s3(), 0.5, 1e-15);
    EXPECT_NEAR(right.s0(), 0.5, 1e-15);
    EXPECT_NEAR(right.s3(), 0.5, 1e-15);
    EXPECT_NEAR(left.s0(), 0, 1e-15);
}

TEST(Mueller, HalfWavePlateMirrorsAndMakesNoCircularLight) {
    const auto out = elements::half_wave_fast_x<double>() * Stokes<double, 4>{{1, 0, 1, 0}};
    EXPECT_EQ(out.s2(), -1);
    EXPECT_EQ(out.s3(), 0);
}

TEST(Mueller, FastAxisYIsFastAxisXTurned) {
    const double c = std::cos(0.9), s = std::sin(0.9);
    const auto turned = rotated(elements::retarder_fast_x(c, s), turn_by(pi / 2));
    const auto fast_y = elements::retarder_fast_y(c, s);
    for (int i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j) EXPECT_NEAR(turned[i][j], fast_y[i][j], 1e-15);
}

/// Every interface maps realizable light to realizable light of no more power.
TEST(Mueller, InterfacesArePassiveAndRealizable) {
    RandomLight random(7);
    for (int i = 0; i < 200000 / light_test_scale; ++i) {
        const double c = random.unit(), n = std::pow(10.0, random.between(-3, 3)),
                     k = std::pow(10.0, random.between(-3, 2));
        const Vector<double> e = random.direction();
        const Stokes<double, 4> light{{1, e.x, e.y, e.z}};
        const auto dielectric = dielectric_interface(c, n);
        const auto metal = conductor_interface(c, n, k).reflection;
        for (const auto& event : {dielectric.reflection, dielectric.transmission, metal}) {
            const auto out = event * light;
            // The matrix elements carry 2e-15, so a state that should stay pure may leave the sphere by that.
            ASSERT_TRUE(out.s0() >= polarized_intensity(out) - 4e-15) << c << ' ' << n << ' ' << k;
            ASSERT_LE(event.a + std::abs(event.b), 1 + 2e-15);
        }
        ASSERT_NEAR(dielectric.reflection.a + dielectric.transmission.a, 1, 4e-15) << c << ' ' << n;
        ASSERT_NEAR(dielectric.reflection.b + dielectric.transmission.b, 0, 4e-15);
    }
}

}  // namespace
}  // namespace brewster
