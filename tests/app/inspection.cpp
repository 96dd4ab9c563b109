#include "app/inspection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brewster {
namespace {

/// 2 x 1 pixels: linear light at 45 degrees, and right circular light of three times its radiance.
StokesPicture two_pixels() {
    StokesPicture picture(2, 1);
    picture.of(Plane::s0) = {glm::vec3(1), glm::vec3(3)};
    picture.of(Plane::s2) = {glm::vec3(0.5f), glm::vec3(0)};
    picture.of(Plane::s3) = {glm::vec3(0), glm::vec3(3)};
    picture.of(Plane::unpolarized) = {glm::vec3(0.9f), glm::vec3(2.9f)};
    for (const Plane plane : {Plane::s0, Plane::s1, Plane::s2, Plane::s3})
        picture.variance_of(plane) = {glm::vec3(0.01f), glm::vec3(0.04f)};
    return picture;
}

TEST(SeenLight, OnePixel) {
    const SeenLight linear = seen_light(two_pixels(), {0, 0}, {1, 1}, true);
    EXPECT_NEAR(linear.dolp(), 0.5, 1e-6);
    EXPECT_NEAR(linear.aolp_degrees(), 45, 1e-6);
    EXPECT_NEAR(linear.passed(45), 0.75, 1e-6);
    EXPECT_NEAR(linear.passed(-45), 0.25, 1e-6);
    EXPECT_NEAR(linear.error[0][0], 0.1, 1e-6);
    EXPECT_NEAR(linear.dolp_floor(), 0.1 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(linear.luminance(), 1, 1e-6);
    const SeenLight circular = seen_light(two_pixels(), {1, 0}, {2, 1}, true);
    EXPECT_NEAR(circular.docp(), 1, 1e-6);
    EXPECT_NEAR(circular.dolp(), 0, 1e-6);
}

TEST(SeenLight, MeanOverARegionAndBeyondTheBorder) {
    const SeenLight mean = seen_light(two_pixels(), {-5, -5}, {9, 9}, true);
    EXPECT_NEAR(mean.stokes[1][0], 2, 1e-6);
    EXPECT_NEAR(mean.error[1][0], std::sqrt(0.05) / 2, 1e-6);
    const SeenLight off = seen_light(two_pixels(), {0, 0}, {1, 1}, false);
    EXPECT_NEAR(off.stokes[0][0], 0.9, 1e-6);
    EXPECT_EQ(off.dolp(), 0);
}

TEST(SeenLight, TheDarkHasNoDegree) {
    const SeenLight dark;
    EXPECT_EQ(dark.dolp(), 0);
    EXPECT_EQ(dark.docp(), 0);
    EXPECT_EQ(dark.passed(30), 0);
}

TEST(BrewsterAngle, OfClearInterfacesOnly) {
    Material material;
    EXPECT_FALSE(brewster_angle(material));
    material.interface.kind = InterfaceKind::dielectric;
    material.interface.n = glm::vec3(10.0f);
    EXPECT_NEAR(*brewster_angle(material), 84.2894, 1e-3);  // theory 2.7
    material.interface.kind = InterfaceKind::conductor;
    EXPECT_FALSE(brewster_angle(material));
}

}  // namespace
}  // namespace brewster
