#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "scene/test_materials.h"
#include "transport/thesis/thesis_gloss.h"

namespace brewster {
namespace {

/// Mean weight of 1e5 draws: the energy that a mirror of facets sends on, their reflectance being nearly 1.
template <class Sampler>
double energy(const PreparedMaterial& metal, double degrees, const Sampler& sampler) {
    const auto angle = static_cast<float>(degrees * pi / 180);
    const SurfacePoint<float> at{{std::sin(angle), 0, std::cos(angle)}, {0, 1, 0}, {0, 0, 1}, false, {}};
    constexpr int draws = 100000;
    double sum = 0;
    for (std::uint32_t i = 0; i < draws; ++i) {
        const auto words = philox(7, i, 0, 0);
        ScatterNumbers<float> numbers;
        numbers.facet_u = unit_float(words[0]);
        numbers.facet_v = unit_float(words[1]);
        numbers.facet_w = unit_float(words[2]);
        const auto sample = sampler(metal, at, numbers);
        if (sample.alive) sum += static_cast<double>(sample.weight[0].m00);
    }
    return sum / draws;
}

double thesis_over_engine(float m, double degrees) {
    using namespace test_materials;
    Material metal = over(InterfaceKind::conductor, glm::vec3(1), glm::vec3(1000), Base::black);
    metal.interface.finish = Finish::beckmann;
    metal.interface.slope = m;
    const PreparedMaterial prepared = prepare_materials({metal})[0];
    return energy(prepared, degrees, [](const auto&... x) { return transport::thesis_gloss<1>(x...); }) /
           energy(prepared, degrees, [](const auto&... x) { return sample_gloss<1>(x...); });
}

// The bias that the quadratures of theory 3.7 give for acceptance S(theta_i) against both shadowings, m = 2 alpha. The
// spread of 1e5 weights below 1 is 2e-3 at most.
TEST(ThesisGloss, HasTheThesissOwnBiasAndNoOther) {
    EXPECT_NEAR(thesis_over_engine(0.2f, 0), 1.000, 0.01);
    EXPECT_NEAR(thesis_over_engine(0.2f, 60), 1.028, 0.01);
    EXPECT_NEAR(thesis_over_engine(0.4f, 60), 1.096, 0.01);
    EXPECT_NEAR(thesis_over_engine(0.4f, 75), 0.84, 0.01);
}

}  // namespace
}  // namespace brewster
