#include "scene/spherical_triangle.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "optics/random_light.h"

namespace brewster {
namespace {

using SphereCorners = std::array<Vector<double>, 3>;

TEST(SphericalTriangle, SolidAngles) {
    EXPECT_NEAR(SphericalTriangle(SphereCorners{{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}).solid_angle(), pi / 2, 1e-14);
    // Half of a quarter of a cube's face, one of 48.
    EXPECT_NEAR(SphericalTriangle(SphereCorners{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}}).solid_angle(), 4 * pi / 48, 1e-14);
    // Seen from its plane it is flat, from inside of it a half sphere.
    EXPECT_NEAR(SphericalTriangle(SphereCorners{{{1, 0, 0}, {2, 1, 0}, {2, -1, 0}}}).solid_angle(), 0, 1e-14);
    EXPECT_NEAR(SphericalTriangle(SphereCorners{{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}}).solid_angle(), 2 * pi, 1e-14);
}

/// A cut through the triangle parts the samples as it parts the solid angle, whichever corner it goes through.
TEST(SphericalTriangle, SamplesAreEvenlySpread) {
    RandomLight random(3);
    for (const SphereCorners& corners : {SphereCorners{{{0.3, 0.2, 1}, {2, -1, 0.5}, {-0.5, 1.5, 0.2}}},
                                         SphereCorners{{{1, 0, 0.01}, {-1, 1, 0.01}, {-1, -1, 0.01}}},
                                         SphereCorners{{{10, 0, 1}, {10, 0.2, 1}, {10, 0, 2}}}}) {
        const SphericalTriangle triangle(corners);
        const int draws = 40000 / light_test_scale;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector<double>&a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
            const Vector<double> between = b + 0.4 * (c - b), cut = cross(a, between);
            const double share =
                SphericalTriangle(SphereCorners{{a, b, between}}).solid_angle() / triangle.solid_angle();
            double found = 0;
            for (int n = 0; n < draws; ++n) {
                const Vector<double> d = triangle.sample(random.unit(), random.unit());
                ASSERT_NEAR(dot(d, d), 1, 1e-12);
                if ((dot(d, cut) > 0) == (dot(b, cut) > 0)) found += 1.0 / draws;
            }
            EXPECT_NEAR(found, share, 4.5 * std::sqrt(share * (1 - share) / draws));
        }
    }
}

}  // namespace
}  // namespace brewster
