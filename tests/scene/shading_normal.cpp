#include "scene/shading_normal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optics/random_light.h"

namespace brewster {
namespace {

TEST(ShadingNormal, OneForEqualNormalsAndSymmetric) {
    RandomLight random(1);
    for (int n = 0; n < 1000; ++n) {
        const Vector<double> i = random.direction(), r = random.direction(), s = random.direction(),
                             g = random.direction();
        EXPECT_DOUBLE_EQ(shading_normal_correction(i, r, g, g), 1);
        const double forth = shading_normal_correction(i, r, s, g), back = shading_normal_correction(r, i, s, g);
        if (forth < 2 && back < 2) {
            EXPECT_NEAR(forth * back, 1, 1e-9);
        }
    }
}

TEST(ShadingNormal, RatioOfCosinesCappedAtTwo) {
    const Vector<double> g{0, 0, 1}, s{std::sin(0.2), 0, std::cos(0.2)}, r{0, 0, 1};
    const auto at = [](double t) { return Vector<double>{std::sin(t), 0, std::cos(t)}; };
    EXPECT_NEAR(shading_normal_correction(at(0.5), r, s, g), std::cos(0.3) / (std::cos(0.5) * std::cos(0.2)), 1e-12);
    EXPECT_EQ(shading_normal_correction(at(1.5), r, s, g), 2);
}

}  // namespace
}  // namespace brewster
