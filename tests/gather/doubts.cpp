#include <gtest/gtest.h>

#include <algorithm>

#include "gather/gather_test.h"
#include "optics/random_light.h"
#include "reference/hand_made.h"
#include "scene/test_materials.h"

/// Draws that follow rays where bins err by more than 2 % of the light, in place of the bins.
namespace brewster {
namespace {

constexpr double deviations_allowed = 3.5;

std::vector<double> looks(const std::shared_ptr<const Scene>& scene, const Snapshot& bins, const Camera& camera,
                          bool doubts, std::uint32_t batches = 1) {
    Draw how;
    if (doubts) how.tolerance = 0.02f;
    return independent_looks(scene, bins, camera, how, batches);
}

/// In a box of grey walls whose bins say 3 lux of direct and 1 of indirect light everywhere, rays that gather find 4 rho
/// lux where the direct light is known exactly, and where it errs as much, 1 rho: no shadow ray finds the lamp outside.
TEST(Doubts, IndirectLightIsGatheredWhereBinsErr) {
    constexpr double rho = 0.5, read = rho * 1 / pi;
    const auto expect = [&](double radiance, float error, bool direct_errs, bool doubts, bool mirror) {
        HandMade room;
        room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(grey(static_cast<float>(rho))));
        room.square("lamp", {0, 0, 9}, {0, 0, 1}, 0.1, room.add(emitter(glm::vec3(1.0f))));
        if (mirror) room.square("mirror", {0, 0, 20}, {0, 0, 1}, 0.1, room.add(test_materials::gold()));
        const auto scene = room.finish();
        const auto bins = even_bins(*scene, 3, 1, error);
        for (std::size_t texel = 0; texel < bins->leaves.size(); ++texel)
            if (!direct_errs && texel / BREWSTER_LEAF_TEXELS % 2 == 0) bins->leaves[texel].w = 0;
        for (const double x : looks(scene, *bins, looking({0, 0, 0}, {1, 2, 0.3}, 10), doubts))
            ASSERT_NEAR(x, radiance, 1e-5) << error << direct_errs << doubts << mirror;
    };
    expect(rho * rho * 4 / pi, 0.09f, false, true, false);
    expect(rho * rho * 1 / pi, 0.09f, true, true, false);
    // The controls: bins that err by less, a draw that believes them, light that the bins may not know.
    expect(read, 0.07f, true, true, false);
    expect(read, 0.09f, true, false, false);
    expect(read, 0.09f, true, true, true);
}

/// Young bins err everywhere, and so few draws of a ray would not be better: only what errs by more than most is in doubt.
TEST(Doubts, YoungBinsAreDoubtedWhereTheyErrByMoreThanMost) {
    HandMade room;
    room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(grey(0.5f)));
    const auto scene = room.finish();
    const auto look = [&](float error) {
        const auto bins = even_bins(*scene, 0, 1, error);
        bins->relative_error = 0.1;
        return looks(scene, *bins, looking({0, 0, 0}, {1, 2, 0.3}, 10), true)[0];
    };
    EXPECT_NEAR(look(0.11f), 0.5 / pi, 1e-5);
    EXPECT_NEAR(look(0.13f), 0.25 / pi, 1e-5);
}

/// What few rays scatter by is more than bins err by: a pixel's n-th draw doubts what errs by more than half over sqrt(n).
/// Here that is 2.25 % of the light, where the 494th begins; rays find half of what bins say.
TEST(Doubts, FewDrawsBelieveMore) {
    HandMade room;
    room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(grey(0.5f)));
    const auto scene = room.finish();
    const auto bins = even_bins(*scene, 0, 4, 0.09f);
    const auto look = [&](std::uint32_t draws) {
        return mean_of(gathered(scene, bins, looking({0, 0, 0}, {1, 2, 0.3}, 10), 2, 2, draws), Plane::s0).mean;
    };
    EXPECT_NEAR(look(256), 2 / pi, 1e-5);
    EXPECT_NEAR(look(2048), (493 + 0.5 * (2048 - 493)) / 2048 * 2 / pi, 1e-4);
}

/// White things in a furnace of lamps alone stay 1: rays that gather pass by the lamps, which shadow rays have found,
/// and the bins' 7 lux of indirect light, which are not true, are not read.
TEST(Doubts, LampsAreNotSeenTwice) {
    Material plastic = test_materials::beckmann(test_materials::dielectric(Base::polarized_diffuse), 0.4f);
    plastic.albedo = glm::vec3(1.0f);
    for (const Material& material : {grey(1.0f), plastic}) {
        HandMade room;
        room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(emitter(glm::vec3(1.0f))));
        room.box("thing", {-0.5f, -0.4f, -0.6f}, {0.5f, 0.6f, 0.4f}, false, room.add(material));
        const auto scene = room.finish();
        const auto bins = even_bins(*scene, 100, 7, 5);
        const Camera camera = looking({1.2, 0.9, 1.5}, glm::dvec3(0.0), 10);
        const std::uint32_t batches = light_test_scale == 1 ? 40 : 8;
        const PlaneMean seen = mean_of(looks(scene, *bins, camera, true, batches));
        EXPECT_NEAR(seen.mean, 1, deviations_allowed * seen.error) << material.name;
        EXPECT_LT(seen.error, 0.05) << material.name;
        EXPECT_GT(mean_of(looks(scene, *bins, camera, false, batches)).mean, 1.5) << material.name;  // the control
    }
}

/// A plate of gold that the sun touches edge-on mirrors a sunlit floor: shadow rays find what exact bins say.
TEST(Doubts, LobesAskTheSunWhereBinsErr) {
    HandMade room;
    room.square("floor", {0, 0, 0}, {0, 0, 1}, 50, room.add(grey(0.5f)));
    room.square("plate", {0, 0, 1}, {0, -1, 0}, 0.2, room.add(test_materials::beckmann(test_materials::gold(), 0.3f)));
    Lamp sun = slanting_sun();
    sun.direction = glm::normalize(glm::vec3(1, 0, -1));
    room.lamp(sun);
    const auto scene = room.finish();
    const Camera camera = looking({0, -2, 1.5}, {0, 0, 1}, 1);
    const auto lux = static_cast<float>(4 * std::sqrt(0.5));
    const std::vector<double> exact = looks(scene, *even_bins(*scene, lux, 0), camera, true);
    const auto wrong_bins = even_bins(*scene, 100, 0, 50);
    const std::vector<double> asked = looks(scene, *wrong_bins, camera, true);
    const std::vector<double> believed = looks(scene, *wrong_bins, camera, false);
    EXPECT_GT(*std::max_element(exact.begin(), exact.end()), 0.1);
    for (std::size_t k = 0; k < exact.size(); ++k) ASSERT_NEAR(asked[k], exact[k], 1e-4) << k;
    EXPECT_GT(mean_of(believed).mean, 2 * mean_of(exact).mean);  // the control
}

}  // namespace
}  // namespace brewster
