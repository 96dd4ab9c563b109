#include "scene/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optics/direction_histogram.h"
#include "optics/random_light.h"
#include "scene/test_materials.h"

namespace brewster {
namespace {

constexpr std::size_t bands = 3;
using Light = Stokes<double, 4>;
const Vector<double> up{0, 0, 1};

Vector<double> above(double cosine, double azimuth = 0.3) {
    const double s = std::sqrt((1 - cosine) * (1 + cosine));
    return {s * std::cos(azimuth), s * std::sin(azimuth), cosine};
}

ScatterNumbers<double> numbers(RandomLight& random) {
    return {random.unit(), random.unit(), random.unit(), random.unit(), random.unit(), random.unit(), random.unit()};
}

SurfacePoint<double> point(RandomLight& random, const Vector<double>& towards, bool inside = false) {
    const Vector<double> other = random.direction();
    return {towards, normalized(cross(towards, other)), up, inside, {0.6, 0.8, 0}};
}

Light random_state(RandomLight& random) {
    const Vector<double> state = random.unit() * random.direction();
    return {{1, state.x, state.y, state.z}};
}

/// The directions a material is looked at from: both sides of glass.
std::vector<bool> sides(const PreparedMaterial& material) {
    if (material.base == Base::transparent && !material.thin) return {false, true};
    return {false};
}

template <Use use>
void chi_square(std::uint64_t seed) {
    RandomLight random(seed);
    const std::vector<PreparedMaterial> materials = prepare_materials(test_materials::all());
    const auto names = test_materials::all();
    const int draws = 60000 / light_test_scale;
    for (std::size_t m = 0; m < materials.size(); ++m) {
        if (materials[m].sharp()) continue;
        for (const double cosine : {0.95, 0.4}) {
            const SurfacePoint<double> at = point(random, above(cosine));
            DirectionHistogram histogram;
            for (int n = 0; n < draws; ++n) {
                const auto sample = sample_bsdf<use, bands>(materials[m], at, numbers(random));
                histogram.add(sample.alive && !sample.sharp ? sample.direction : -up);
            }
            const auto expected = cell_probabilities([&](const Vector<double>& o) {
                const auto value = use == Use::light ? evaluate_bsdf<use, bands>(materials[m], -at.towards, o, up)
                                                     : evaluate_bsdf<use, bands>(materials[m], -o, at.towards, up);
                return (value.has_gloss ? value.gloss.pdf : 0) + (value.has_base ? value.base.pdf : 0);
            });
            EXPECT_GT(chi_square_p(histogram.cells, expected), sidak_level(40)) << names[m].name << ' ' << cosine;
        }
    }
}

TEST(Bsdf, LightSideSamplesFollowTheirDensity) {
    chi_square<Use::light>(1);
}
TEST(Bsdf, EyeSideSamplesFollowTheirDensity) {
    chi_square<Use::eye>(2);
}

/// Uniformly drawn directions against the density of a gloss lobe, or its samples against 5 % more slope: both noticed.
TEST(Bsdf, WrongDensitiesAreNoticed) {
    RandomLight random(3);
    const auto materials = prepare_materials({test_materials::beckmann(test_materials::gold(), 0.3f),
                                              test_materials::beckmann(test_materials::gold(), 0.315f)});
    const SurfacePoint<double> at = point(random, above(0.7));
    DirectionHistogram histogram;
    for (int n = 0; n < 60000; ++n) {
        const auto sample = sample_bsdf<Use::light, bands>(materials[0], at, numbers(random));
        histogram.add(sample.alive ? sample.direction : -up);
    }
    const auto expected = cell_probabilities([&](const Vector<double>& o) {
        return evaluate_bsdf<Use::light, bands>(materials[1], -at.towards, o, up).gloss.pdf;
    });
    EXPECT_LT(chi_square_p(histogram.cells, expected), 1e-4);
}

/// The weight of a sample is the evaluated lobe times the cosine over the density, as a Stokes operator between the
/// frames that the caller knows, in both uses.
template <Use use>
void weight_is_value_over_density(std::uint64_t seed) {
    RandomLight random(seed);
    const auto names = test_materials::all();
    const std::vector<PreparedMaterial> materials = prepare_materials(names);
    for (std::size_t m = 0; m < materials.size(); ++m) {
        int compared = 0;
        for (int n = 0; n < 3000 / light_test_scale; ++n) {
            const SurfacePoint<double> at = point(random, above(random.between(0.05, 1), random.between(0, 6)));
            const auto sample = sample_bsdf<use, bands>(materials[m], at, numbers(random));
            if (!sample.alive || sample.sharp || sample.direction.z < 1e-3) continue;
            const bool light_side = use == Use::light;
            const Vector<double> in = light_side ? -at.towards : -sample.direction;
            const Vector<double> out = light_side ? sample.direction : at.towards;
            const auto value = evaluate_bsdf<use, bands>(materials[m], in, out, up);
            const LobeValue<double, bands>& lobe = sample.base ? value.base : value.gloss;
            ASSERT_NEAR(sample.pdf / lobe.pdf, 1, 1e-6) << names[m].name;
            const Light light = random_state(random);
            // Light comes in the frame of `in_axis`, is wanted in that of `out_axis`.
            const Vector<double> in_axis = light_side ? at.carried_axis : sample.axis;
            const Vector<double> out_axis = light_side ? sample.axis : at.carried_axis;
            for (std::size_t band = 0; band < bands; ++band) {
                const Light sampled = light_side ? sample.weight[band] * rotate(sample.turn, light)
                                                 : rotate(sample.turn, sample.weight[band] * light);
                const Light evaluated =
                    rotate(rotation_between(out, lobe.axis_out, out_axis),
                           (sample.direction.z / lobe.pdf) *
                               (lobe.value[band] * rotate(rotation_between(in, in_axis, lobe.axis_in), light)));
                for (int j = 0; j < 4; ++j)
                    ASSERT_NEAR(sampled[j], evaluated[j], 1e-6 * (1 + sampled.s0())) << names[m].name << " S" << j;
            }
            ++compared;
        }
        EXPECT_EQ(compared > 0, !materials[m].sharp()) << names[m].name;
    }
}

TEST(Bsdf, LightSideWeightIsValueTimesCosineOverDensity) {
    weight_is_value_over_density<Use::light>(4);
}
TEST(Bsdf, EyeSideWeightIsValueTimesCosineOverDensity) {
    weight_is_value_over_density<Use::eye>(5);
}

/// Light sent back along its path meets Q M^T Q, Q = diag(1,1,-1,1): in s frames m01 and m10 change places, c and d stay.
TEST(Bsdf, Reciprocity) {
    RandomLight random(6);
    const auto names = test_materials::all();
    const std::vector<PreparedMaterial> materials = prepare_materials(names);
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (int n = 0; n < 2000 / light_test_scale; ++n) {
            const Vector<double> i = above(random.between(0.01, 1), random.between(0, 6));
            const Vector<double> r = above(random.between(0.01, 1), random.between(0, 6));
            const auto forth = evaluate_bsdf<Use::light, bands>(materials[m], -i, r, up);
            const auto back = evaluate_bsdf<Use::light, bands>(materials[m], -r, i, up);
            for (const bool base : {false, true}) {
                if (!(base ? forth.has_base : forth.has_gloss)) continue;
                const auto &a = base ? forth.base : forth.gloss, &b = base ? back.base : back.gloss;
                for (std::size_t band = 0; band < bands; ++band) {
                    const PlanarMueller<double> x = a.value[band], y = b.value[band];
                    const double slack = 1e-6 * x.m00 + 1e-300;
                    ASSERT_NEAR(x.m00, y.m00, slack) << names[m].name;
                    ASSERT_NEAR(x.m01, y.m10, slack) << names[m].name;
                    ASSERT_NEAR(x.m10, y.m01, slack) << names[m].name;
                    ASSERT_NEAR(x.m11, y.m11, slack) << names[m].name;
                    ASSERT_NEAR(x.c, y.c, slack) << names[m].name;
                    ASSERT_NEAR(x.d, y.d, slack) << names[m].name;
                }
            }
        }
}

struct Albedo {
    std::array<double, bands> s_light{}, p_light{}, unpolarized{}, error{};
};

/// Reflected and transmitted share of s-, p- and unpolarized light, or, for the eye, of what each side of an analyzer
/// shows of light from everywhere.
template <Use use>
Albedo albedo(const PreparedMaterial& material, double cosine, bool inside, RandomLight& random, int draws) {
    Albedo sum;
    std::array<double, bands> squares{};
    for (int n = 0; n < draws; ++n) {
        SurfacePoint<double> at{above(cosine), {}, up, inside, {0.6, 0.8, 0}};
        at.carried_axis = plane_of_incidence(-at.towards, normalized(cross(at.towards, random.direction())), up).axis;
        const auto sample = sample_bsdf<use, bands>(material, at, numbers(random));
        if (!sample.alive) continue;
        // Undo the eye's radiance factor: this is about power.
        const double n2 = material.base == Base::transparent && !material.thin && use == Use::eye && sample.refracted
                              ? std::pow(static_cast<double>(material.refracting_n), inside ? -2 : 2)
                              : 1;
        for (std::size_t band = 0; band < bands; ++band) {
            const PlanarMueller<double>& w = sample.weight[band];
            const double s1 = use == Use::light ? w.m01 * sample.turn.cos_2t : sample.turn.cos_2t * w.m10;
            sum.s_light[band] += n2 * (w.m00 + s1) / draws;
            sum.p_light[band] += n2 * (w.m00 - s1) / draws;
            sum.unpolarized[band] += n2 * w.m00 / draws;
            squares[band] += 4 * n2 * n2 * w.m00 * w.m00 / draws;
            EXPECT_LE(n2 * w.m00, 3.3);
        }
    }
    for (std::size_t band = 0; band < bands; ++band) sum.error[band] = std::sqrt(squares[band] / draws);
    return sum;
}

/// No material returns more than it gets, in either use and polarization. The bound is 4.5 standard errors above 1:
/// 234 comparisons fail with probability 1e-3.
TEST(Bsdf, NoMaterialReturnsMoreThanItGets) {
    RandomLight random(7);
    const auto names = test_materials::all();
    const std::vector<PreparedMaterial> materials = prepare_materials(names);
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (const double cosine : {0.9, 0.5, 0.1})
            for (const bool inside : sides(materials[m])) {
                const int draws = 20000 / light_test_scale;
                const Albedo light = albedo<Use::light>(materials[m], cosine, inside, random, draws);
                const Albedo eye = albedo<Use::eye>(materials[m], cosine, inside, random, draws);
                for (std::size_t band = 0; band < bands; ++band) {
                    EXPECT_LE(light.s_light[band], 1 + 4.5 * light.error[band]) << names[m].name << ' ' << cosine;
                    EXPECT_LE(light.p_light[band], 1 + 4.5 * light.error[band]) << names[m].name << ' ' << cosine;
                    EXPECT_LE(eye.s_light[band], 1 + 4.5 * eye.error[band]) << names[m].name << ' ' << cosine;
                    EXPECT_LE(eye.p_light[band], 1 + 4.5 * eye.error[band]) << names[m].name << ' ' << cosine;
                    // Reciprocity of the whole, through different samplers.
                    const double error = light.error[band] + eye.error[band];
                    EXPECT_NEAR(light.unpolarized[band], eye.unpolarized[band], 4.5 * error) << names[m].name;
                    EXPECT_NEAR(light.s_light[band], eye.s_light[band], 4.5 * error) << names[m].name;
                }
            }
}

/// White bases and glass lose nothing, whatever the polarization.
TEST(Bsdf, LosslessMaterialsReturnEverything) {
    RandomLight random(8);
    Material smooth = test_materials::dielectric(Base::polarized_diffuse);
    smooth.albedo = glm::vec3(1.0f);
    const std::vector<Material> white = {smooth, test_materials::beckmann(smooth, 0.4f),
                                         test_materials::kirchhoff(smooth, 0.1f, 1.5f),
                                         test_materials::dielectric(Base::transparent), test_materials::pane()};
    for (const PreparedMaterial& material : prepare_materials(white))
        for (const double cosine : {0.9, 0.4, 0.15})
            for (const bool inside : sides(material)) {
                const Albedo light = albedo<Use::light>(material, cosine, inside, random, 40000 / light_test_scale);
                const Albedo eye = albedo<Use::eye>(material, cosine, inside, random, 40000 / light_test_scale);
                for (const Albedo& a : {light, eye}) {
                    EXPECT_NEAR(a.unpolarized[0], 1, 4.5 * a.error[0]) << static_cast<int>(material.finish) << cosine;
                    EXPECT_NEAR(a.s_light[0], 1, 4.5 * a.error[0]) << static_cast<int>(material.finish) << cosine;
                    EXPECT_NEAR(a.p_light[0], 1, 4.5 * a.error[0]) << static_cast<int>(material.finish) << cosine;
                }
            }
}

TEST(Bsdf, RealizableLightStaysRealizable) {
    RandomLight random(9);
    const auto names = test_materials::all();
    const std::vector<PreparedMaterial> materials = prepare_materials(names);
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (const bool inside : sides(materials[m]))
            for (int n = 0; n < 3000 / light_test_scale; ++n) {
                const auto at = point(random, above(random.between(0.02, 1), random.between(0, 6)), inside);
                const Vector<double> pole = random.direction();
                const Light light{{1, pole.x, pole.y, pole.z}};
                const auto sample = sample_bsdf<Use::light, bands>(materials[m], at, numbers(random));
                if (!sample.alive) continue;
                ASSERT_NEAR(dot(sample.direction, sample.direction), 1, 1e-9) << names[m].name;
                ASSERT_NEAR(dot(sample.axis, sample.axis), 1, 1e-9) << names[m].name;
                ASSERT_NEAR(dot(sample.axis, sample.direction), 0, 1e-9) << names[m].name;
                for (std::size_t band = 0; band < bands; ++band)
                    // The tables of rough interfaces are floats.
                    ASSERT_TRUE(realizable(sample.weight[band] * rotate(sample.turn, light), 1e-6)) << names[m].name;
            }
}

/// The same light described in another frame goes the same way with the same state.
TEST(Bsdf, TheCarriedFrameDoesNotMatter) {
    RandomLight random(10);
    const std::vector<PreparedMaterial> materials = prepare_materials(test_materials::all());
    for (const PreparedMaterial& material : materials)
        for (int n = 0; n < 500; ++n) {
            const SurfacePoint<double> at = point(random, above(random.between(0.1, 1)));
            const ScatterNumbers<double> drawn = numbers(random);
            const Light light = random_state(random);
            const double angle = random.between(0, pi);
            SurfacePoint<double> turned = at;
            turned.carried_axis =
                std::cos(angle) * at.carried_axis + std::sin(angle) * cross(-at.towards, at.carried_axis);
            const auto a = sample_bsdf<Use::light, bands>(material, at, drawn);
            const auto b = sample_bsdf<Use::light, bands>(material, turned, drawn);
            ASSERT_EQ(a.alive, b.alive);
            if (!a.alive) continue;
            for (std::size_t band = 0; band < bands; ++band) {
                const Light x = a.weight[band] * rotate(a.turn, light);
                const Light y = b.weight[band] * rotate(b.turn, rotate(turn_by(angle), light));
                const Light z = rotate(rotation_between(a.direction, b.axis, a.axis), y);
                for (int j = 0; j < 4; ++j) ASSERT_NEAR(x[j], z[j], 1e-9);
            }
        }
}

/// Snell, total reflection, and radiance that is n^2 times as dense inside.
TEST(Bsdf, GlassRefracts) {
    RandomLight random(11);
    const PreparedMaterial glass = prepare_materials({test_materials::dielectric(Base::transparent)})[0];
    for (int n = 0; n < 2000; ++n) {
        const double cosine = random.between(0.05, 1);
        const bool inside = n % 2 == 1;
        const auto at = point(random, above(cosine), inside);
        const auto light = sample_bsdf<Use::light, 1>(glass, at, numbers(random));
        const double sine = std::sqrt(1 - cosine * cosine), refracted = inside ? 1.5 * sine : sine / 1.5;
        if (refracted > 1) {
            ASSERT_FALSE(light.refracted);
            ASSERT_NEAR(light.weight[0].m00, 1, 1e-12);
        }
        if (!light.refracted) continue;
        ASSERT_NEAR(light.direction.z, -std::sqrt(1 - refracted * refracted), 1e-7);
        ASSERT_NEAR(light.weight[0].m00, 1, 1e-7);  // power is conserved, the choice took the rest
        const auto eye = sample_bsdf<Use::eye, 1>(glass, at, ScatterNumbers<double>{0.9999});
        if (eye.refracted) {
            ASSERT_NEAR(eye.weight[0].m00, inside ? 2.25 : 1 / 2.25, 1e-6);
        }
    }
}

/// Both worlds: the gloss of the interface alone is the same lobe as the choice's, without the choice.
TEST(Bsdf, GlossAloneHasTheSameMeanAsTheChoice) {
    RandomLight random(12);
    const auto materials =
        prepare_materials({test_materials::beckmann(test_materials::dielectric(Base::polarized_diffuse), 0.4f)});
    double alone = 0, chosen = 0;
    const int draws = 100000 / light_test_scale;
    for (int n = 0; n < draws; ++n) {
        const auto at = point(random, above(0.5));
        const auto a = sample_gloss<bands>(materials[0], at, numbers(random));
        const auto b = sample_bsdf<Use::light, bands>(materials[0], at, numbers(random));
        if (a.alive) alone += a.weight[0].m00 / draws;
        if (b.alive && !b.base) chosen += b.weight[0].m00 / draws;
    }
    const double expected = 1 - materials[0].passage(0, 0.5).unpolarized;
    EXPECT_NEAR(alone, expected, 4.5 * std::sqrt(expected / draws));
    EXPECT_NEAR(chosen, expected, 4.5 * std::sqrt(expected / draws));
}

TEST(Bsdf, LanesHaveTheBitsOfFloats) {
    RandomLight random(13);
    const auto materials = prepare_materials(test_materials::all());
    for (const PreparedMaterial& material : materials)
        for (int n = 0; n < 50; ++n) {
            std::array<SurfacePoint<float>, lane_count> at;
            std::array<ScatterNumbers<float>, lane_count> drawn;
            SurfacePoint<FloatLanes> batch;
            ScatterNumbers<FloatLanes> batch_drawn;
            for (std::size_t lane = 0; lane < lane_count; ++lane) {
                const auto exact = point(random, above(random.between(0.01, 1)));
                const auto vector = [](const Vector<double>& v) {
                    return Vector<float>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
                };
                at[lane] = {vector(exact.towards), vector(exact.carried_axis), vector(exact.normal), false,
                            vector(exact.filter_axis)};
                drawn[lane] = {random.unit_float(), random.unit_float(), random.unit_float(), random.unit_float(),
                               random.unit_float(), random.unit_float(), random.unit_float()};
                const auto put = [lane](FloatLanes& to, float from) { to[lane] = from; };
                const auto put3 = [&](Vector<FloatLanes>& to, const Vector<float>& from) {
                    put(to.x, from.x), put(to.y, from.y), put(to.z, from.z);
                };
                put3(batch.towards, at[lane].towards);
                put3(batch.carried_axis, at[lane].carried_axis);
                put3(batch.normal, at[lane].normal);
                put3(batch.filter_axis, at[lane].filter_axis);
                put(batch_drawn.choice, drawn[lane].choice);
                put(batch_drawn.exit_u, drawn[lane].exit_u);
                put(batch_drawn.exit_v, drawn[lane].exit_v);
                put(batch_drawn.slope, drawn[lane].slope);
                put(batch_drawn.facet_u, drawn[lane].facet_u);
                put(batch_drawn.facet_v, drawn[lane].facet_v);
                put(batch_drawn.facet_w, drawn[lane].facet_w);
            }
            const auto lanes = sample_bsdf<Use::light, bands>(material, batch, batch_drawn);
            for (std::size_t lane = 0; lane < lane_count; ++lane) {
                const auto one = sample_bsdf<Use::light, bands>(material, at[lane], drawn[lane]);
                ASSERT_EQ(one.alive, lanes.alive[lane]);
                if (!one.alive) continue;
                ASSERT_EQ(one.direction.x, lanes.direction.x[lane]);
                ASSERT_EQ(one.direction.z, lanes.direction.z[lane]);
                ASSERT_EQ(one.pdf, lanes.pdf[lane]);
                ASSERT_EQ(one.turn.sin_2t, lanes.turn.sin_2t[lane]);
                for (std::size_t band = 0; band < bands; ++band) {
                    ASSERT_EQ(one.weight[band].m00, lanes.weight[band].m00[lane]);
                    ASSERT_EQ(one.weight[band].m10, lanes.weight[band].m10[lane]);
                    ASSERT_EQ(one.weight[band].d, lanes.weight[band].d[lane]);
                }
            }
        }
}

}  // namespace
}  // namespace brewster
