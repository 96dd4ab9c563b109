#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "optics/fresnel.h"
#include "random_light.h"
#include "reference_table.h"

/// The Fresnel kernels in float against the same formulas in double, fed the same (float) inputs.
namespace brewster {
namespace {

/// Largest |float - double| of a quantity, with the inputs that gave it.
struct Worst {
    double error = 0, c = 0, n = 0, k = 0;
    void note(double value, double truth, double cosine, double index, double absorption) {
        const double e = std::abs(value - truth);
        if (!(e <= error)) {
            error = e;
            c = cosine;
            n = index;
            k = absorption;
        }
    }
    void print(const char* name) const {
        std::printf("float  %-28s %.2e at cos_theta_i %.9g, n %.9g, k %.9g\n", name, error, c, n, k);
    }
};

/// cos_theta_i in [0, 1] with many small values and values near 1; the index over 1e-3 .. 1e3, half of it in 0.5 .. 3.
struct Inputs {
    float c, n, k;
};
Inputs random_inputs(RandomLight& random) {
    const double kind = random.unit();
    double c = random.unit();
    if (kind < 0.1) c = std::pow(10.0, -8 * c);
    if (kind > 0.9) c = 1 - std::pow(10.0, -7 * c);
    const double n = random.unit() < 0.5 ? std::pow(10.0, random.between(-3, 3)) : random.between(0.5, 3);
    return {static_cast<float>(c), static_cast<float>(n), static_cast<float>(std::pow(10.0, random.between(-4, 3)))};
}

void expect_physical(const DielectricInterface<float>& at, const Inputs& in) {
    for (const float value :
         {at.rs.re, at.rs.im, at.rp.re, at.rp.im, at.ts, at.tp, at.Ts, at.Tp, at.cos_theta_t, at.reflection.a,
          at.reflection.b, at.reflection.c, at.reflection.d, at.transmission.a, at.transmission.b, at.transmission.c})
        ASSERT_TRUE(std::isfinite(value)) << in.c << ' ' << in.n;
    ASSERT_TRUE(at.Rs >= 0 && at.Rs <= 1 && at.Rp >= 0 && at.Rp <= 1) << in.c << ' ' << in.n;
    ASSERT_TRUE(at.Ts >= 0 && at.Ts <= 1 && at.Tp >= 0 && at.Tp <= 1) << in.c << ' ' << in.n;
}
void expect_physical(const ConductorInterface<float>& at, const Inputs& in) {
    for (const float value :
         {at.rs.re, at.rs.im, at.rp.re, at.rp.im, at.reflection.a, at.reflection.b, at.reflection.c, at.reflection.d})
        ASSERT_TRUE(std::isfinite(value)) << in.c << ' ' << in.n << ' ' << in.k;
    ASSERT_TRUE(at.Rs >= 0 && at.Rs <= 1 && at.Rp >= 0 && at.Rp <= 1) << in.c << ' ' << in.n << ' ' << in.k;
}

TEST(FresnelFloat, TenMillionRandomInputsArePhysical) {
    RandomLight random(21);
    for (int i = 0; i < 5000000 / light_test_scale; ++i) {
        const Inputs in = random_inputs(random);
        ASSERT_NO_FATAL_FAILURE(expect_physical(dielectric_interface(in.c, in.n), in));
        ASSERT_NO_FATAL_FAILURE(expect_physical(conductor_interface(in.c, in.n, in.k), in));
    }
}

/// Denormals, zeros, ones and their neighbours, Brewster's and the critical angle and their neighbours.
TEST(FresnelFloat, AdversarialInputsArePhysical) {
    std::vector<float> cosines = {0.0f,     std::numeric_limits<float>::denorm_min(),
                                  1e-45f,   1e-40f,
                                  1.2e-38f, 1e-30f,
                                  3e-20f,   1e-19f,
                                  1e-10f,   1e-7f,
                                  0.5f,     0.70710678f,
                                  1.0f};
    const std::vector<float> indices = {1e-3f, 0.1f, 0.5f, 0.66666667f, 0.999f, 1.0f, 1.001f, 1.5f, 2.4f, 10.0f, 1e3f};
    for (const float n : indices) {
        cosines.push_back(1 / std::sqrt(1 + n * n));                 // Brewster
        if (n < 1) cosines.push_back(std::sqrt((1 - n) * (1 + n)));  // critical
    }
    const std::vector<float> absorptions = {0.0f, 1e-45f, 1e-39f, 1e-30f, 1e-20f, 1e-7f, 1e-3f, 1.0f, 7.0f, 1e3f};
    int cases = 0;
    for (const float cosine : cosines)
        for (const float index : indices)
            for (int step_c = -3; step_c <= 3; ++step_c)
                for (int step_n = -3; step_n <= 3; ++step_n) {
                    const auto moved = [](float x, int steps) {
                        for (; steps > 0; --steps) x = std::nextafter(x, 2e3f);
                        for (; steps < 0; ++steps) x = std::nextafter(x, 0.0f);
                        return x;
                    };
                    const Inputs in{std::min(moved(cosine, step_c), 1.0f), moved(index, step_n), 0};
                    ASSERT_NO_FATAL_FAILURE(expect_physical(dielectric_interface(in.c, in.n), in));
                    for (const float k : absorptions)
                        ASSERT_NO_FATAL_FAILURE(expect_physical(conductor_interface(in.c, in.n, k), {in.c, in.n, k}));
                    ++cases;
                }
    EXPECT_GE(cases, 10000);
}

TEST(FresnelFloat, DielectricBounds) {
    RandomLight random(22);
    Worst power, amplitude, matrix, phase, transmitted;
    for (int i = 0; i < 2000000 / light_test_scale; ++i) {
        const Inputs in = random_inputs(random);
        const auto f = dielectric_interface(in.c, in.n);
        const auto d = dielectric_interface(static_cast<double>(in.c), static_cast<double>(in.n));
        power.note(f.Rs, d.Rs, in.c, in.n, 0);
        power.note(f.Rp, d.Rp, in.c, in.n, 0);
        amplitude.note(f.rs.re, d.rs.re, in.c, in.n, 0);
        amplitude.note(f.rp.re, d.rp.re, in.c, in.n, 0);
        amplitude.note(f.rs.im, d.rs.im, in.c, in.n, 0);
        amplitude.note(f.rp.im, d.rp.im, in.c, in.n, 0);
        matrix.note(f.reflection.a, d.reflection.a, in.c, in.n, 0);
        matrix.note(f.reflection.b, d.reflection.b, in.c, in.n, 0);
        phase.note(f.reflection.c, d.reflection.c, in.c, in.n, 0);
        phase.note(f.reflection.d, d.reflection.d, in.c, in.n, 0);
        transmitted.note(f.Ts, d.Ts, in.c, in.n, 0);
        transmitted.note(f.Tp, d.Tp, in.c, in.n, 0);
        transmitted.note(f.transmission.c, d.transmission.c, in.c, in.n, 0);
    }
    power.print("dielectric Rs Rp");
    amplitude.print("dielectric rs rp");
    matrix.print("dielectric A B");
    phase.print("dielectric C D");
    transmitted.print("dielectric Ts Tp q");
    // Two dozen roundings of 6e-8 each on quantities of at most 1.
    EXPECT_LE(power.error, 2e-6);
    EXPECT_LE(amplitude.error, 1.5e-6);
    EXPECT_LE(matrix.error, 1.5e-6);
    EXPECT_LE(phase.error, 1.5e-6);
    EXPECT_LE(transmitted.error, 1.5e-6);
}

TEST(FresnelFloat, DielectricRelativeBound) {
    // Relative errors too stay small, Brewster and critical angle included: no cancellation is left.
    const ReferenceTable table("fresnel_dielectric");
    double worst = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const float c = static_cast<float>(table(row, "cos_theta")), n = static_cast<float>(table(row, "n"));
        const auto f = dielectric_interface(c, n);
        const auto d = dielectric_interface(static_cast<double>(c), static_cast<double>(n));
        const auto relative = [&](double value, double truth) {
            if (std::abs(truth) > 1e-30) worst = std::max(worst, std::abs(value / truth - 1));
        };
        relative(f.Rs, d.Rs);
        relative(f.Rp, d.Rp);
        relative(f.reflection.b, d.reflection.b);
        relative(f.Ts, d.Ts);
        relative(f.Tp, d.Tp);
    }
    std::printf("float  dielectric, relative        %.2e\n", worst);
    EXPECT_LE(worst, 1e-5);
}

TEST(FresnelFloat, ConductorBounds) {
    RandomLight random(23);
    Worst power, amplitude, matrix;
    for (int i = 0; i < 2000000 / light_test_scale; ++i) {
        const Inputs in = random_inputs(random);
        const auto f = conductor_interface(in.c, in.n, in.k);
        const auto d =
            conductor_interface(static_cast<double>(in.c), static_cast<double>(in.n), static_cast<double>(in.k));
        power.note(f.Rs, d.Rs, in.c, in.n, in.k);
        power.note(f.Rp, d.Rp, in.c, in.n, in.k);
        amplitude.note(f.rs.re, d.rs.re, in.c, in.n, in.k);
        amplitude.note(f.rs.im, d.rs.im, in.c, in.n, in.k);
        amplitude.note(f.rp.re, d.rp.re, in.c, in.n, in.k);
        amplitude.note(f.rp.im, d.rp.im, in.c, in.n, in.k);
        matrix.note(f.reflection.a, d.reflection.a, in.c, in.n, in.k);
        matrix.note(f.reflection.b, d.reflection.b, in.c, in.n, in.k);
        matrix.note(f.reflection.c, d.reflection.c, in.c, in.n, in.k);
        matrix.note(f.reflection.d, d.reflection.d, in.c, in.n, in.k);
    }
    power.print("conductor Rs Rp");
    amplitude.print("conductor rs rp");
    matrix.print("conductor A B C D");
    EXPECT_LE(power.error, 2e-6);
    EXPECT_LE(amplitude.error, 1.5e-6);
    EXPECT_LE(matrix.error, 1.5e-6);
}

}  // namespace
}  // namespace brewster
