// Light that runs along a surface.
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "hard/hard.h"
#include "optics/fresnel.h"
#include "optics/planar_mueller.h"

namespace brewster {
namespace {

// What passes an interface falls with the cosine c: 4 c / sqrt(n^2 - 1) for s, n^2 times that for p.
TEST(Grazing, FresnelKeepsWhatPasses) {
    constexpr double n = 1.5;
    for (const double angle : {89.99, 89.9999, 89.999999, 89.9999999}) {
        const double c = std::sin(radians(90 - angle)), passing = 4 * c / std::sqrt(n * n - 1);
        const auto exact = planar(dielectric_interface(c, n).reflection);
        EXPECT_NEAR(exact.m00 + exact.m01, 1 - passing, 4 * passing * passing + 1e-15) << angle;
        EXPECT_NEAR(exact.m00 - exact.m01, 1 - n * n * passing, 4 * std::pow(n * n * passing, 2) + 1e-15) << angle;
        const auto single = planar(dielectric_interface(static_cast<float>(c), 1.5f).reflection);
        EXPECT_NEAR(static_cast<double>(single.m00), exact.m00, 0x1p-21) << angle;
        EXPECT_LE(single.m00, 1.0f) << angle;
        const auto metal = planar(conductor_interface(static_cast<float>(c), 0.2f, 3.0f).reflection);
        EXPECT_LE(metal.m00, 1.0f) << angle;
        EXPECT_GT(metal.m00, 0.99f) << angle;
    }
}

// A sun that grazes the floor of a courtyard: lux times the cosine, as long as floats can tell where its rays land; then
// too little light to see, never too much.
TEST(Grazing, SunsGrazeFloors) {
    for (const double angle : {89.0, 89.9, 89.99}) {
        SceneFile file;
        file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, file.material(0));
        const double c = std::sin(radians(90 - angle));
        file.sun(1000, {std::sqrt(1 - c * c), -c, 0});
        expect_value(solved(file, 20000).on("floor"), 1000 * c, "grazing sun");
    }
    SceneFile file;
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, file.material(0));
    const double c = std::sin(radians(1e-7));
    file.sun(1000, {1, -c, 0});
    const Measured found = solved(file, 20000).on("floor");
    std::printf("at 89.9999999 degrees: %.3g of %.3g\n", found.mean, 1000 * c);
    EXPECT_LE(found.mean, 1000 * c * 1.001 + 4 * found.error);
}

}  // namespace
}  // namespace brewster
