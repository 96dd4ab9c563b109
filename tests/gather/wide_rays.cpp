#include <gtest/gtest.h>

#include "gather/gather_test.h"
#include "reference/hand_made.h"
#include "scene/bsdf.h"
#include "scene/test_materials.h"

/// Second rays by the cosine at rough gloss, for what glares where the lobe hardly ever points.
namespace brewster {
namespace {

constexpr double deviations_allowed = 3.5;
constexpr std::uint32_t batches = 400;

PlaneMean look(const std::shared_ptr<const Scene>& scene, const Snapshot& bins, const Camera& camera, bool wide,
               std::optional<std::size_t> component = {}) {
    Draw how;
    how.goes_wide = wide;
    return mean_of(independent_looks(scene, bins, camera, how, batches, component));
}

/// What reaches the eye by way of a gloss at the origin, facing up, from a square that shines.
struct Glare {
    std::array<double, 3> stokes{};  ///< S0 to S2 for a camera that is upright
    double deviation = 0;            ///< of single draws of the lobe, which never miss but for the square
};

Glare glare_of(const Material& gloss, const glm::dvec3& eye, const glm::dvec3& middle, double half, double radiance) {
    const PreparedMaterial prepared = prepare_materials({gloss}).front();
    const Vector<double> normal{0, 0, 1}, towards = normalized(Vector<double>{eye.x, eye.y, eye.z});
    const Vector<double> axis = normalized(cross(-towards, Vector<double>{0, 0, 1}));
    Glare glare;
    double squares = 0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            // The square faces -x.
            const Vector<double> to{middle.x, middle.y + half * (2 * (i + 0.5) / steps - 1),
                                    middle.z + half * (2 * (j + 0.5) / steps - 1)};
            const double square = dot(to, to), area = 4 * half * half / (steps * steps);
            const Vector<double> direction = normalized(to);
            const auto lobe = evaluate_gloss<Use::eye, band_count>(prepared, -direction, towards, normal);
            const double weight = direction.z * radiance, solid_angle = area * direction.x / square;
            const auto light =
                rotate(rotation_between(towards, lobe.axis_out, axis), lobe.value[0] * unpolarized<4>(weight));
            for (int c = 0; c < 3; ++c) glare.stokes[static_cast<std::size_t>(c)] += solid_angle * light[c];
            const double whole = lobe.value[0].m00 * weight;
            squares += solid_angle * whole * whole / lobe.pdf;
        }
    glare.deviation = std::sqrt(squares - glare.stokes[0] * glare.stokes[0]);
    return glare;
}

/// A bright wall beside a dark floor: its light is what an integral over the wall says, polarization as well, and scatters
/// far less than draws of the lobe would.
TEST(WideRays, FindWhatTheLobeHardlyEverDraws) {
    const Material gloss = test_materials::beckmann(test_materials::dielectric(Base::black), 0.25f);
    const glm::dvec3 eye(0, -2, 2), middle(2, 0, 1.5);
    constexpr double half = 0.4, rho = 0.5, lux = 1000;
    HandMade room;
    room.square("floor", {0, 0, 0}, {0, 0, 1}, 0.1, room.add(gloss));
    room.square("wall", middle, {-1, 0, 0}, half, room.add(grey(static_cast<float>(rho))));
    const auto scene = room.finish();
    const auto bins = even_bins(*scene, static_cast<float>(lux), 0);
    const Camera camera = looking(eye, {0, 0, 0}, 0.01);
    const Glare glare = glare_of(gloss, eye, middle, half, rho * lux / pi);
    const double draws = batches * static_cast<double>(eye_batch);
    const PlaneMean seen = look(scene, *bins, camera, true);
    EXPECT_NEAR(seen.mean, glare.stokes[0], deviations_allowed * seen.error);
    EXPECT_LT(seen.error, 0.2 * glare.stokes[0]);
    EXPECT_LT(seen.error, 0.3 * glare.deviation / std::sqrt(draws));
    for (const std::size_t component : {0u, 1u, 2u}) {
        const PlaneMean part = look(scene, *bins, camera, true, component);
        EXPECT_NEAR(part.mean, glare.stokes[component], deviations_allowed * part.error) << component;
        EXPECT_GT(std::abs(part.mean), 2 * part.error) << component;  // there is something to be told
    }
}

/// Three ways find a lamp by way of gloss: points on it, the lobe, wide rays. Together they find it once.
TEST(WideRays, ShareLampsWithOtherWays) {
    for (const Material& gloss : {test_materials::beckmann(test_materials::gold(), 0.5f),
                                  test_materials::kirchhoff(test_materials::gold(), 0.1f, 1.0f)}) {
        HandMade room;
        room.box("lamp", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(emitter(glm::vec3(1.0f))));
        room.square("plate", {0, 0, 0}, {0, 0, 1}, 0.5, room.add(gloss));
        const auto scene = room.finish();
        const auto bins = even_bins(*scene, 0, 0);
        const Camera camera = looking({0, -1, 0.7}, {0, 0, 0}, 1);
        const PlaneMean wide = look(scene, *bins, camera, true), narrow = look(scene, *bins, camera, false);
        EXPECT_NEAR(wide.mean, narrow.mean, deviations_allowed * std::hypot(wide.error, narrow.error)) << gloss.name;
        EXPECT_LT(wide.error, 0.003 * wide.mean) << gloss.name;
        EXPECT_NE(wide.mean, narrow.mean) << gloss.name;  // wide rays were drawn
    }
}

/// Behind and before a pane all is gloss, and each draw has two rays already: there is room for no third one.
TEST(WideRays, LeaveDrawsThatHavePartedAlone) {
    HandMade room;
    const Material gloss = test_materials::beckmann(test_materials::dielectric(Base::polarized_diffuse), 0.3f);
    room.box("wall", glm::vec3(-2.0f), glm::vec3(2.0f), true, room.add(gloss));
    room.square("pane", {0, 0, 0}, {0, -1, 0.2}, 1, room.add(test_materials::pane()));
    const auto scene = room.finish();
    const auto bins = even_bins(*scene, 3, 1);
    Draw how;
    how.eagerness = 1000;  // always both
    const Camera camera = looking({0, -1, 0.1}, {0, 0, 0}, 10);
    const std::vector<double> plain = independent_looks(scene, *bins, camera, how);
    how.goes_wide = true;
    EXPECT_EQ(independent_looks(scene, *bins, camera, how), plain);
}

}  // namespace
}  // namespace brewster
