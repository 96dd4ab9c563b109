#include "optics/stokes.h"

#include <gtest/gtest.h>

#include "optics/frame.h"
#include "optics/mueller.h"
#include "optics/polarization_state.h"
#include "random_light.h"

namespace brewster {
namespace {

Stokes<double, 4> random_stokes(RandomLight& random) {
    const Vector<double> e = random.direction();
    const double s0 = random.between(0.1, 3), p = random.unit() * s0;
    return {{s0, p * e.x, p * e.y, p * e.z}};
}

TEST(Stokes, DegreesAndAngles) {
    const Stokes<double, 4> light{{2, 0.6, -0.8, 0.5}};
    EXPECT_NEAR(dolp(light), 0.5, 1e-15);
    EXPECT_NEAR(docp(light), 0.25, 1e-15);
    EXPECT_NEAR(dop(light), std::sqrt(1 + 0.25) / 2, 1e-15);
    EXPECT_NEAR(aolp(light), 0.5 * std::atan2(-0.8, 0.6), 1e-15);
    EXPECT_EQ(aolp(Stokes<double, 4>{{1, -1, 0, 0}}), pi / 2);
    EXPECT_EQ(aolp(Stokes<double, 4>{{1, -1, -0.0, 0}}), pi / 2);
}

TEST(Stokes, DarkAndUnpolarizedLightHaveNoNaN) {
    const Stokes<double, 4> dark{};
    EXPECT_EQ(dop(dark), 0);
    EXPECT_EQ(dolp(dark), 0);
    EXPECT_EQ(docp(dark), 0);
    EXPECT_EQ(aolp(dark), 0);
    EXPECT_EQ(polarization_ellipse(dark).semi_major, 0);
    EXPECT_EQ(made_realizable(dark).s0(), 0);
    EXPECT_EQ(split_into_antipodes(unpolarized<4>(1.0)).first.s1(), 0.5);
}

TEST(Stokes, FewerComponentsAreTheSameLight) {
    const Stokes<double, 4> four{{1, 0.3, 0.4, 0}};
    const Stokes<double, 3> three{{1, 0.3, 0.4}};
    const Stokes<double, 1> one{{1}};
    EXPECT_EQ(dop(four), dop(three));
    EXPECT_EQ(dop(one), 0);
    const auto turn = turn_by(0.4);
    EXPECT_EQ(rotate(turn, four).s1(), rotate(turn, three).s1());
    EXPECT_EQ(rotate(turn, one).s0(), 1);
    const InterfaceMueller<double> event{0.5, 0.2, -0.1, 0};
    EXPECT_EQ((event * four).s0(), (event * three).s0());
    EXPECT_EQ((event * one).s0(), 0.5);
    const std::array<Stokes<double, 3>, 3> bands{three, 2.0 * three, three + three};
    EXPECT_EQ(bands[1].s0(), bands[2].s0());
}

TEST(Stokes, DecompositionsAddUpAndAreRealizable) {
    RandomLight random(2);
    for (int i = 0; i < 20000; ++i) {
        const auto light = random_stokes(random);
        for (const StokesPair& pair : {split_by_polarization(light), split_into_antipodes(light)}) {
            const auto sum = pair.first + pair.second;
            for (int j = 0; j < 4; ++j) ASSERT_NEAR(sum[j], light[j], 1e-15 * light.s0() * 2);
            ASSERT_TRUE(realizable(pair.first, 1e-14));
            ASSERT_TRUE(realizable(pair.second, 1e-14));
        }
        const StokesPair antipodes = split_into_antipodes(light);
        ASSERT_NEAR(dop(antipodes.first), 1, 1e-14);
        ASSERT_NEAR(antipodes.first.s0() - antipodes.second.s0(), polarized_intensity(light), 1e-14);
    }
}

TEST(Stokes, EllipseCarriesThePolarizedPower) {
    RandomLight random(3);
    for (int i = 0; i < 20000; ++i) {
        const auto light = random_stokes(random);
        const PolarizationEllipse ellipse = polarization_ellipse(light);
        const double a = ellipse.semi_major, b = ellipse.semi_minor;
        ASSERT_NEAR(a * a + b * b, polarized_intensity(light), 1e-14);
        ASSERT_NEAR(2 * a * b, std::abs(light.s3()), 1e-14);
        ASSERT_NEAR((a * a - b * b) * std::cos(2 * ellipse.orientation), light.s1(), 1e-14);
        ASSERT_NEAR((a * a - b * b) * std::sin(2 * ellipse.orientation), light.s2(), 1e-14);
        ASSERT_EQ(ellipse.ellipticity > 0, light.s3() > 0);
    }
}

TEST(Stokes, RealizabilityIsTestedAndRestored) {
    const Stokes<double, 4> longer{{1, 0.8, 0.6, 0.1}};
    EXPECT_FALSE(realizable(longer, 1e-9));
    EXPECT_TRUE(realizable(made_realizable(longer), 1e-15));
    const Stokes<double, 4> fine{{1, 0.8, 0.5, 0.1}};
    EXPECT_EQ(made_realizable(fine).s1(), fine.s1());
    EXPECT_FALSE(realizable(Stokes<double, 4>{{-1, 0, 0, 0}}, 1e-9));
}

}  // namespace
}  // namespace brewster
