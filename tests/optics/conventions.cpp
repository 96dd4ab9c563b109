#include "optics/conventions.h"

#include <gtest/gtest.h>

#include <complex>

#include "optics/fresnel.h"
#include "optics/materials.h"
#include "optics/polarization_state.h"
#include "random_light.h"

/// One test a sign of conventions.h.
namespace brewster {
namespace {

using Complexd = std::complex<double>;

/// Stokes vector of two complex amplitudes under exp(+i w t).
Stokes<double, 4> stokes_of_field(Complexd ex, Complexd ey) {
    const Complexd cross = 2.0 * std::conj(ex) * ey;
    return {{std::norm(ex) + std::norm(ey), std::norm(ex) - std::norm(ey), cross.real(), cross.imag()}};
}

TEST(Conventions, S2IsPositiveFromXTowardsY) {
    const auto diagonal = stokes_of_field(1, 1);
    EXPECT_GT(diagonal.s2(), 0);
    EXPECT_NEAR(aolp(diagonal), pi / 4, 1e-15);
    // Seen by the receiver y = k x X lies counter-clockwise of x, so the frame turned by +45 degrees has it along x.
    EXPECT_NEAR(rotate(turn_by(pi / 4), diagonal).s1(), diagonal.s0(), 1e-15);
}

TEST(Conventions, S3IsPositiveForFieldTurningClockwise) {
    // d = dy - dx = +90 degrees: Ex = cos wt, Ey = cos(wt + 90) = -sin wt: from x towards -y, clockwise with y up.
    const auto light = stokes_of_field(1, Complexd(0, 1));
    EXPECT_EQ(light.s3(), 2);
    const double wt = 0.1;
    const double ex0 = 1, ey0 = 0, ex1 = std::cos(wt), ey1 = std::cos(wt + pi / 2);
    EXPECT_LT(ex0 * ey1 - ey0 * ex1, 0);
    EXPECT_GT(polarization_ellipse(light).ellipticity, 0);
}

TEST(Conventions, FrameIsRightHanded) {
    // s = k x n and p = k x s before and after: p_r = -p_i at normal incidence.
    const auto plane = plane_of_incidence(Vector<double>{0, 0, -1}, {1, 0, 0}, {0, 0, 1});
    EXPECT_EQ(plane.axis.x, 1);
    const Vector<double> p_before = cross(Vector<double>{0, 0, -1}, plane.axis);
    const Vector<double> p_after = cross(Vector<double>{0, 0, 1}, plane.axis);
    EXPECT_EQ(p_before.y, -p_after.y);
}

TEST(Conventions, AxisIsPerpendicularToPlaneOfIncidenceAndSigned) {
    const Vector<double> k = normalized(Vector<double>{1, 0, -1}), n{0, 0, 1};
    const auto plane = plane_of_incidence(k, {0, 1, 0}, n);
    const Vector<double> s = normalized(cross(k, n));
    EXPECT_NEAR(dot(plane.axis, s), 1, 1e-15);
}

TEST(Conventions, VerdetSignOfRp) {
    const auto at = dielectric_interface(1.0, 1.5);
    EXPECT_NEAR(at.rs.re, -0.2, 1e-15);
    EXPECT_NEAR(at.rp.re, 0.2, 1e-15);
    const auto metal = conductor_interface(1.0, 0.2, 3.4);
    EXPECT_NEAR(metal.rs.re, -metal.rp.re, 1e-15);
    EXPECT_NEAR(metal.rs.im, -metal.rp.im, 1e-15);
}

TEST(Conventions, MirrorSwapsHandedness) {
    const auto out = mueller_reflection(1.0, 0.05, 4.0) * Stokes<double, 4>{{1, 0, 0.6, 0.8}};
    EXPECT_LT(out.s3(), 0);
    EXPECT_LT(out.s2(), 0);
}

TEST(Conventions, PositiveS1IsSPolarized) {
    const double brewster_cosine = 1 / std::hypot(1, 1.5);
    const auto event = mueller_reflection(brewster_cosine, 1.5);
    EXPECT_NEAR((event * Stokes<double, 4>{{1, -1, 0, 0}}).s0(), 0, 1e-16);  // p is not reflected
    EXPECT_NEAR((event * Stokes<double, 4>{{1, 1, 0, 0}}).s0(), std::pow(1.25 / 3.25, 2), 1e-15);
}

TEST(Conventions, EtaIsTransmittedOverIncident) {
    EXPECT_LT(dielectric_interface(0.3, 1.5).Rs, 1);      // into glass: always something passes
    EXPECT_EQ(dielectric_interface(0.3, 1 / 1.5).Rs, 1);  // out of glass at 73 degrees: total
    EXPECT_NEAR(dielectric_interface(0.5, 1.5).cos_theta_t, std::sqrt(1 - 0.75 / 2.25), 1e-15);
}

TEST(Conventions, GoldTurnsDiagonalIntoRightCircular) {
    const auto event = mueller_reflection(std::cos(radians(70)), 0.183, 3.43);
    EXPECT_NEAR(event.c, -0.2912, 5e-5);
    EXPECT_NEAR(event.d, 0.8896, 5e-5);
    EXPECT_GT((event * Stokes<double, 4>{{1, 0, 1, 0}}).s3(), 0);
}

TEST(Conventions, FresnelRhombTurnsDiagonalIntoRightCircular) {
    // Two total reflections of 45 degrees each (n = 1.49661, 51.785 degrees).
    const auto event = mueller_reflection(std::cos(radians(51.785)), 1 / 1.49661);
    const auto out = event * (event * Stokes<double, 4>{{1, 0, 1, 0}});
    EXPECT_NEAR(out.s3(), 1, 1e-7);
}

/// conj(rs) rp against the matrix, for a metal and for total reflection.
TEST(Conventions, LowerBlockIsConjugateRsTimesRp) {
    const auto check = [](const auto& at) {
        const Complexd product = std::conj(Complexd(at.rs.re, at.rs.im)) * Complexd(at.rp.re, at.rp.im);
        EXPECT_NEAR(at.reflection.c, product.real(), 1e-15);
        EXPECT_NEAR(at.reflection.d, product.imag(), 1e-15);
        EXPECT_GT(at.reflection.d, 0);
    };
    check(conductor_interface(0.4, 0.183, 3.43));
    check(dielectric_interface(0.4, 1 / 1.5));
}

TEST(Conventions, ConductorWithoutAbsorptionIsTheDielectric) {
    RandomLight random(4);
    for (int i = 0; i < 20000; ++i) {
        const double c = random.unit(), n = random.between(1.01, 10);
        const auto metal = conductor_interface(c, n, 0.0), glass = conductor_interface(c, n, 1e-300);
        const auto dielectric = dielectric_interface(c, n);
        for (const auto& event : {metal.reflection, glass.reflection}) {
            ASSERT_NEAR(event.a, dielectric.reflection.a, 2e-15);
            ASSERT_NEAR(event.b, dielectric.reflection.b, 2e-15);
            ASSERT_NEAR(event.c, dielectric.reflection.c, 2e-15);
            ASSERT_NEAR(event.d, 0, 2e-15);
        }
    }
}

TEST(Conventions, TransmittedLightIsPolarizedAlongP) {
    const auto out = dielectric_interface(0.3, 1.5).transmission * unpolarized<4>(1.0);
    EXPECT_LT(out.s1(), 0);
}

TEST(Conventions, FastAxisLeads) {
    // Slow y lags: under exp(+i w t) Ey gets exp(-i G). +45 degrees becomes left circular at G = 90.
    const auto field = stokes_of_field(1, std::polar(1.0, -pi / 2));
    const auto plate = elements::quarter_wave_fast_x<double>() * stokes_of_field(1, 1);
    EXPECT_NEAR(plate.s3(), field.s3(), 1e-15);
    EXPECT_LT(plate.s3(), 0);
}

/// Figure 8.1 of the thesis: both events at Brewster's angle of n = 10, planes meeting at cos psi = 1/n^2.
TEST(Conventions, DoubleBrewsterOfFigure81) {
    const double n = 10, c = 1 / std::hypot(1, n), Rs = std::pow(99.0 / 101, 2);
    const Vector<double> floor{0, 0, 1};
    // Falls on the floor at Brewster's angle and then on the vertical wall at Brewster's angle.
    const double along_wall = -c;
    const Vector<double> k{std::sqrt(1 - 2 * c * c), along_wall, -c};
    const Vector<double> wall{0, 1, 0};
    const auto first = plane_of_incidence(k, normalized(cross(k, wall)), floor);
    auto light = mueller_reflection(first.cos_theta_i, n) * rotate(first.turn, unpolarized<4>(1.0));
    EXPECT_NEAR(light.s0(), Rs / 2, 1e-12);
    EXPECT_NEAR(light.s0(), 0.480394, 5e-7);
    const Vector<double> k2 = reflected(k, floor);
    const auto second = plane_of_incidence(k2, first.axis, wall);
    light = mueller_reflection(second.cos_theta_i, n) * rotate(second.turn, light);
    EXPECT_NEAR(light.s0(), Rs * Rs / (2 * std::pow(n, 4)), 1e-15);
    EXPECT_NEAR(light.s0(), 4.6156e-5, 5e-10);
}

TEST(Conventions, NamedMaterialsArePhysical) {
    for (const OpticalConstants& material : named_materials)
        for (unsigned band = 0; band < band_count; ++band) {
            const double R = conductor_interface(1.0, material.n[band], material.k[band]).Rs;
            EXPECT_GT(R, 0.015) << material.name;
            EXPECT_LT(R, 0.99) << material.name;
            EXPECT_FALSE(material.source.empty());
        }
    // Normal dispersion of the dielectrics; gold and copper redden, F0 = ((n-1)^2+k^2)/((n+1)^2+k^2).
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_LT(named_materials[i].n[0], named_materials[i].n[1]);
        EXPECT_LT(named_materials[i].n[1], named_materials[i].n[2]);
    }
    const auto F0 = [](unsigned index, unsigned band) {
        const double n = named_materials[index].n[band], k = named_materials[index].k[band];
        return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    };
    EXPECT_GT(F0(7, 0), 2 * F0(7, 2));
    EXPECT_GT(F0(8, 0), 1.4 * F0(8, 2));
    EXPECT_NEAR(conductor_interface(1.0, named_materials[7].n[1], named_materials[7].k[1]).Rp, F0(7, 1), 1e-15);
}

}  // namespace
}  // namespace brewster
