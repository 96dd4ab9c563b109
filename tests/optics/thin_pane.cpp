#include "optics/thin_pane.h"

#include <gtest/gtest.h>

#include "random_light.h"

namespace brewster {
namespace {

/// scene_checks.json, slab_transmittance_incoherent, n = 1.5.
TEST(ThinPane, TransmittanceOfOnePlate) {
    EXPECT_NEAR(thin_pane(1.0, 1.5).transmission.m00, 0.92307692307692308, 1e-14);
    EXPECT_NEAR(thin_pane(std::cos(radians(45)), 1.5).transmission.m00, 0.90734432980162893, 1e-14);
    EXPECT_NEAR(thin_pane(std::cos(radians(75)), 1.5).transmission.m00, 0.61814851625470873, 1e-13);
}

/// scene_checks.json, pile_of_plates_brewster, N = 1.
TEST(ThinPane, OnePlateAtBrewstersAngle) {
    const PlanarMueller<double> through = thin_pane(std::cos(std::atan(1.5)), 1.5).transmission;
    EXPECT_NEAR(through.m00, 0.87113402061855670, 1e-14);
    EXPECT_NEAR(-through.m01 / through.m00, 0.14792899408284024, 1e-14);
}

/// The series summed term by term (2000 of them: near grazing incidence each loses one part in a hundred), each inner reflection by the matrix from inside.
TEST(ThinPane, ClosedFormIsTheSumOfAllReflections) {
    RandomLight random(1);
    for (int n = 0; n < 200; ++n) {
        const double c = random.between(0.05, 1), index = random.between(1.1, 3);
        const auto outside = dielectric_interface(c, index);
        const auto inside = dielectric_interface(outside.cos_theta_t, 1 / index);
        const auto add = [](PlanarMueller<double>& sum, const Mueller<double>& term) {
            sum.m00 += term[0][0], sum.m01 += term[0][1], sum.m10 += term[1][0], sum.m11 += term[1][1];
            sum.c += term[2][2], sum.d += term[3][2];
        };
        PlanarMueller<double> reflected = planar(outside.reflection), passed;
        Mueller<double> light = full_matrix(outside.transmission);
        const Mueller<double> leave = full_matrix(inside.transmission), turn_back = full_matrix(inside.reflection);
        for (int bounce = 0; bounce < 2000; ++bounce) {
            add(bounce % 2 ? reflected : passed, leave * light);
            light = turn_back * light;
        }
        const ThinPane<double> pane = thin_pane(c, index);
        for (const auto& [a, b] : {std::pair(pane.reflection, reflected), std::pair(pane.transmission, passed)}) {
            EXPECT_NEAR(a.m00, b.m00, 1e-9);
            EXPECT_NEAR(a.m01, b.m01, 1e-9);
            EXPECT_NEAR(a.m11, b.m11, 1e-9);
            EXPECT_NEAR(a.c, b.c, 1e-9);
            EXPECT_NEAR(a.d, b.d, 1e-9);
        }
        EXPECT_NEAR(pane.reflection.m00 + pane.transmission.m00, 1, 1e-15);
    }
}

}  // namespace
}  // namespace brewster
