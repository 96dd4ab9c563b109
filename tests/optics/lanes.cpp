#include "base/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

#include "optics/effective_roughness.h"
#include "optics/fresnel.h"
#include "optics/inverted_slopes.h"
#include "optics/poisson_lobes.h"
#include "optics/rough_interface.h"
#include "optics/thesis_sampler.h"
#include "random_light.h"

/// Every per-photon function gives the same bits for a float as for a lane of the batch: a million random events each.
namespace brewster {
namespace {

/// Uniform inputs of one event; functions take what they need, in order.
constexpr std::size_t input_count = 12;

template <class Real>
using Uniforms = std::array<Real, input_count>;

template <class Real>
Vector<Real> unit_vector(const Real& u, const Real& v) {
    const Real z = 2 * u - 1, radius = sqrt(max((1 - z) * (1 + z), Real(0)));
    const SineCosine<Real> turn = sincos_turns(v);
    return {radius * turn.cosine, radius * turn.sine, z};
}

/// Two directions above z = 0.
template <class Real>
std::pair<Vector<Real>, Vector<Real>> two_above(const Uniforms<Real>& u) {
    Vector<Real> i = unit_vector(u[0], u[1]), r = unit_vector(u[2], u[3]);
    i.z = abs(i.z);
    r.z = abs(r.z);
    return {i, r};
}

/// Runs `function(inputs) -> std::array<Real, N>` eight events at a time and one by one, and compares bits.
template <class Function>
void expect_same_bits(const char* name, Function function, int events = 1000000 / light_test_scale) {
    RandomLight random(99);
    long long different = 0, not_a_number = 0;
    for (int n = 0; n < events; n += lane_count) {
        std::array<std::array<float, lane_count>, input_count> values;
        for (auto& row : values)
            for (float& value : row) {
                value = random.unit_float();
                // A few per cent of extremes: 0, the largest below 1, tiny.
                const std::uint32_t kind = random.word() & 127;
                if (kind == 0) value = 0;
                if (kind == 1) value = 0.99999994f;
                if (kind == 2) value *= 1e-6f;
            }
        Uniforms<FloatLanes> batch;
        for (std::size_t j = 0; j < input_count; ++j) batch[j] = load<FloatLanes>(values[j].data());
        const auto wide = function(batch);
        std::array<std::array<float, lane_count>, std::tuple_size_v<decltype(function(batch))>> out;
        for (std::size_t k = 0; k < out.size(); ++k) store(wide[k], out[k].data());
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            Uniforms<float> single;
            for (std::size_t j = 0; j < input_count; ++j) single[j] = values[j][lane];
            const auto narrow = function(single);
            for (std::size_t k = 0; k < out.size(); ++k) {
                const bool differs =
                    std::bit_cast<std::uint32_t>(narrow[k]) != std::bit_cast<std::uint32_t>(out[k][lane]);
                if (differs && different == 0)
                    std::printf("%s, output %zu: scalar %.9g, batch %.9g\n", name, k, static_cast<double>(narrow[k]),
                                static_cast<double>(out[k][lane]));
                different += differs;
                not_a_number += std::isnan(narrow[k]);
            }
        }
    }
    EXPECT_EQ(different, 0) << name;
    EXPECT_EQ(not_a_number, 0) << name;
}

#define SAME_BITS(name, ...)                                                          \
    TEST(SameBits, name) {                                                            \
        expect_same_bits(#name, []<class Real>(const Uniforms<Real>& u) __VA_ARGS__); \
    }

SAME_BITS(Elementary, {
    const SineCosine<Real> turn = sincos_turns(u[0]);
    return std::array{turn.sine,         turn.cosine,        exp(u[1] * 200 - 100),
                      log(u[2]),         erfcx(u[3] * 10),   erfc(u[4] * 20 - 10),
                      erf(u[5] * 8 - 4), acos(u[6] * 2 - 1), one_minus_exp(u[7] * 3)};
})

SAME_BITS(Dielectric, {
    const auto at = dielectric_interface(u[0], u[1] * 4 + constant<Real>(0.001));
    return std::array{at.rs.re,
                      at.rs.im,
                      at.rp.re,
                      at.rp.im,
                      at.Rs,
                      at.Rp,
                      at.ts,
                      at.tp,
                      at.Ts,
                      at.Tp,
                      at.cos_theta_t,
                      at.reflection.a,
                      at.reflection.b,
                      at.reflection.c,
                      at.reflection.d,
                      at.transmission.a,
                      at.transmission.b,
                      at.transmission.c};
})

SAME_BITS(Conductor, {
    const auto at = conductor_interface(u[0], u[1] * 4 + constant<Real>(0.001), u[2] * 9);
    return std::array{at.rs.re, at.rs.im,        at.rp.re,        at.rp.im,        at.Rs,
                      at.Rp,    at.reflection.a, at.reflection.b, at.reflection.c, at.reflection.d};
})

SAME_BITS(FramesAndStokes, {
    const Vector<Real> k = unit_vector(u[0], u[1]), any = unit_vector(u[2], u[3]);
    const Vector<Real> n = select(dot(any, k) > 0, -any, any);
    // An axis orthogonal to k without a singular direction (Duff et al. 2017).
    const Real sign = select(k.z < 0, Real(-1), Real(1)), a = -1 / (sign + k.z);
    const Vector<Real> s{1 + sign * k.x * k.x * a, sign * k.x * k.y * a, -sign * k.x};
    const auto plane = plane_of_incidence(k, s, n);
    const Stokes<Real, 4> light{{Real(1), u[6] - u[7], u[8] - u[7], u[9]}};
    const auto out = made_realizable(rotate(plane.turn, light));
    const Vector<Real> kr = reflected(k, n), t = transported_axis(n, s, kr);
    return std::array{plane.axis.x,
                      plane.axis.y,
                      plane.axis.z,
                      plane.turn.cos_2t,
                      plane.turn.sin_2t,
                      plane.cos_theta_i,
                      out.s0(),
                      out.s1(),
                      out.s2(),
                      out.s3(),
                      dop(light),
                      dolp(light),
                      docp(light),
                      kr.x,
                      kr.y,
                      kr.z,
                      t.x,
                      t.y,
                      rotation_between(k, s, plane.axis).sin_2t};
})

SAME_BITS(MuellerElements, {
    const Stokes<Real, 4> light{{Real(1), u[0] - u[1], u[2] - u[3], u[4] - u[5]}};
    const auto turn = rotation_of(u[6] - constant<Real>(0.5), u[7]);
    const auto out =
        rotated(elements::diattenuator(u[8], u[9]) * elements::retarder_fast_x(turn.cos_2t, turn.sin_2t), turn) * light;
    const auto polarized =
        rotated(elements::polarizer<Real>(), turn) * (elements::right_circular_polarizer<Real>() * light);
    return std::array{out.s0(), out.s1(), out.s2(), out.s3(), polarized.s0(), polarized.s1()};
})

SAME_BITS(ShadowingAndRoughness, {
    const Real m = constant<Real>(0.01) + u[1], h = cotangent_over_slope(u[0], m);
    const auto effective = effective_roughness(excess_slope_he(u[0], m) + excess_slope_he(u[2], m));
    const auto smith = effective_roughness(excess_slope_smith(u[0], m) + excess_slope_smith(u[2], m));
    return std::array{h,
                      smith_g1(h),
                      smith_s(h),
                      effective.sigma_ratio,
                      effective.mean_height,
                      smith.sigma_ratio,
                      lambert_w_of_log(u[3] * 160 - 80),
                      lambert_w(u[4] * 50),
                      beckmann_d(u[5], m)};
})

SAME_BITS(VisibleNormals, {
    const Vector<Real> n{Real(0), Real(0), Real(1)};
    const Real cosine = max(u[0], constant<Real>(1e-4));
    const Vector<Real> k{sqrt((1 - cosine) * (1 + cosine)), Real(0), -cosine};
    const auto plane = plane_of_incidence(k, Vector<Real>{Real(0), Real(1), Real(0)}, n);
    const auto out = sample_facet(k, n, plane, constant<Real>(0.01) + u[1], u[2], u[3], u[4]);
    return std::array{out.direction.x, out.direction.y, out.direction.z, out.cos_r,
                      out.facet.x,     out.facet.y,     out.facet.z};
})

SAME_BITS(InvertedSlopes, {
    const auto slopes = inverted_visible_slopes(u[0] * 4, u[1], u[2]);
    const auto normal = inverted_visible_slopes(constant<Real>(1e15) * u[3], u[1], u[2]);
    return std::array{slopes.along, slopes.across, normal.along};
})

SAME_BITS(BeckmannLobe, {
    const auto [i, r] = two_above(u);
    const auto lobe = beckmann_lobe(i, r, Vector<Real>{Real(0), Real(0), Real(1)}, constant<Real>(0.02) + u[4]);
    return std::array{lobe.value, lobe.pdf_i, lobe.pdf_r, lobe.cos_theta_h};
})

const OrderRules order_rules;
const RoughInterface rough(1.5, 0.3);

SAME_BITS(PoissonLobe, {
    const auto [i, r] = two_above(u);
    const KirchhoffSurface<Real, 3> surface{constant<Real>(0.02) + u[4], {u[5] * 20, u[5] * 22, u[5] * 26}};
    const auto lobe = poisson_lobe(order_rules, i, r, Vector<Real>{Real(0), Real(0), Real(1)}, surface);
    const auto mirror = mirror_share(surface, i.z);
    return std::array{lobe.value[0], lobe.value[1], lobe.value[2], lobe.pdf_i,
                      lobe.pdf_r,    mirror[0],     mirror[2],     sample_slope(order_rules, surface, i.z, u[6])};
})

SAME_BITS(ThesisSampler, {
    const auto [i, r] = two_above(u);
    const Real m = constant<Real>(0.02) + u[4];
    const auto slopes = sample_thesis_slopes(i.z, m, u[5], u[6]);
    return std::array{slopes.along, slopes.across, thesis_pdf(i, r, m)};
})

SAME_BITS(PolarizedDiffuse, {
    const Stokes<Real, 3> light{{Real(1), u[0] - u[1], u[2] - u[3]}};
    const auto in = smooth_passage(u[4], u[5] * 3 + 1), out = rough.passage(u[6]);
    const Real internal = u[7] * constant<Real>(0.9);
    const auto exit = base_radiance<3>(out, entered_power(in, light), base_radiance_factor(u[8], u[5] + 1, internal));
    const Vector<Real> d = sample_cosine(u[9], u[10]);
    return std::array{exit.s0(), exit.s1(), base_survival(u[8], internal), exit_weight(out, internal), d.x, d.y, d.z};
})

/// The whole event of the photon loop.
SAME_BITS(GlossEvent, {
    const Vector<Real> n{Real(0), Real(0), Real(1)};
    const Real cosine = max(u[0], constant<Real>(1e-4));
    const Vector<Real> k{sqrt((1 - cosine) * (1 + cosine)), Real(0), -cosine};
    const SineCosine<Real> turn = sincos_turns(u[1]);
    const Vector<Real> x{Real(0), Real(1), Real(0)}, s = add_scaled(turn.cosine, x, turn.sine * cross(k, x));
    const auto out = sample_facet(k, n, plane_of_incidence(k, s, n), constant<Real>(0.1), u[2], u[3], u[4]);
    const auto plane = plane_of_incidence(k, s, out.facet);
    const Stokes<Real, 4> light{
        {Real(1), u[5] - constant<Real>(0.5), u[6] - constant<Real>(0.5), u[7] - constant<Real>(0.5)}};
    const Real weight = smith_g1(cotangent_over_slope(max(min(out.cos_r, Real(1)), Real(0)), constant<Real>(0.1)));
    const auto after = weight * (mueller_reflection(plane.cos_theta_i, constant<Real>(0.2), constant<Real>(3.4)) *
                                 rotate(plane.turn, light));
    return std::array{after.s0(), after.s1(), after.s2(), after.s3(), plane.axis.x, plane.axis.y};
})

TEST(Lanes, SplitExponentAndPowerOfTwo) {
    for (const float x : {1.0f, 0.70710678f, 0.7071069f, 1.41421356f, 3e-38f, 1e38f, 0.1f}) {
        const auto split = split_exponent(x);
        EXPECT_EQ(split.mantissa * std::ldexp(1.0f, static_cast<int>(split.exponent)), x);
        EXPECT_TRUE(split.mantissa >= 0.70710677f && split.mantissa <= 1.41421366f);
    }
    for (int k = -126; k <= 127; ++k) EXPECT_EQ(power_of_two(static_cast<float>(k)), std::ldexp(1.0f, k));
}

}  // namespace
}  // namespace brewster
