#include <gtest/gtest.h>

#include "gather/eye_tracer.h"
#include "gather/gather_test.h"
#include "reference/hand_made.h"
#include "scene/test_materials.h"

/// At the first glass that is seen, its reflection and what it lets through.
namespace brewster {
namespace {

constexpr double ahead = 1, behind = 8;                  // cd/m2
constexpr double r = 0.04, reflected = 2 * r / (1 + r);  // of a pane of 1.5, both faces (theory 2.3)
constexpr double whole = (1 - reflected) * ahead + reflected * behind;

/// What single draws see straight on in a pane between a lamp ahead and a brighter one behind the camera.
std::vector<double> looks(float eagerness) {
    HandMade room;
    const auto dim = room.add(emitter(glm::vec3(static_cast<float>(ahead))));
    const auto bright = room.add(emitter(glm::vec3(static_cast<float>(behind))));
    room.square("ahead", {0, 0, -3}, {0, 0, 1}, 2, dim);
    room.square("behind", {0, 0, 3}, {0, 0, -1}, 2, bright);
    room.square("pane", {0, 0, -1}, {0, 0, 1}, 0.5, room.add(test_materials::pane()));
    const auto scene = room.finish();
    const EyeScene eye_scene(*scene);
    std::vector<Draw> draws;
    for (std::uint32_t k = 0; k < eye_batch; ++k) {
        Draw draw{0, 0, {sequence_key(1, k, 0), 0}};  // a sequence of its own: independent
        draw.eagerness = eagerness;
        draws.push_back(draw);
    }
    EyeTracer tracer;
    const auto seen = std::make_unique<LevelLight>();
    tracer.trace(eye_scene, *even_bins(*scene, 0, 0), looking({0, 0, 1}, {0, 0, -1}, 0.01), 1, 1, draws, *seen);
    return {seen->stokes[0].begin(), seen->stokes[0].begin() + eye_batch};
}

std::size_t near_to(double value, const std::vector<double>& seen) {
    return static_cast<std::size_t>(
        std::count_if(seen.begin(), seen.end(), [&](double x) { return std::abs(x - value) < 1e-4 * value; }));
}

/// The mean of n looks that see `low`, and with probability p `high` instead: 3.5 standard errors.
void expect_mean(const std::vector<double>& seen, double p, double low, double high) {
    double mean = 0;
    for (const double x : seen) mean += x / static_cast<double>(seen.size());
    EXPECT_EQ(near_to(low, seen) + near_to(high, seen), seen.size());
    EXPECT_NEAR(mean, whole, 3.5 * (high - low) * std::sqrt(p * (1 - p) / static_cast<double>(seen.size())));
}

TEST(BothWays, EveryLookSeesBoth) {
    EXPECT_EQ(near_to(whole, looks(1e6f)), eye_batch);
}

/// The weaker way, the reflection, with 4 times its share as probability, and then a fourth of its light as weight.
TEST(BothWays, TheWeakerOneNowAndThen) {
    const double through = (1 - reflected) * ahead;
    expect_mean(looks(4), 4 * reflected, through, through + behind / 4);
}

/// The control: one of both, and no look sees the whole.
TEST(BothWays, OneOfBothIsRightOnTheMeanAlone) {
    const std::vector<double> seen = looks(0);
    expect_mean(seen, reflected, ahead, behind);
    EXPECT_EQ(near_to(whole, seen), 0u);
}

}  // namespace
}  // namespace brewster
