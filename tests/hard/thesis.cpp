// The habits of the 1997 method, kept to compare with: slower to converge, but right where the thesis is right.
#include <gtest/gtest.h>

#include "base/units.h"
#include "bins/lookup.h"
#include "engine/slow.h"
#include "hard/hard.h"

namespace brewster {
namespace {

struct Habits {
    bool cells, splits, absorption;
};

EngineSettings settings_of(const Habits& habits) {
    EngineSettings settings;
    settings.bins.constant_cells = habits.cells;
    settings.bins.join_corners = !habits.cells;
    settings.bins.half_differences = habits.splits;
    settings.thesis.analog = habits.absorption;
    return settings;
}

/// A black room of 1 m, whose ceiling glows with radiance 1, on a floor that keeps half.
SceneFile dark_room() {
    SceneFile file;
    const int black = file.material(0), lamp = file.material(0, 1), grey = file.material(0.5);
    file.quad("floor", {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, grey);
    file.quad("ceiling", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, lamp);
    file.quad("back", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, black);
    file.quad("left", {0, 0, 1}, {0, 0, -1}, {0, 1, 0}, black);
    return file;
}

class ThesisVariants : public ::testing::TestWithParam<Habits> {};

TEST_P(ThesisVariants, LightAnOppositeWallByItsFormFactor) {
    const Solved result = solved(dark_room(), slow ? 4000 : 40000, settings_of(GetParam()));
    expect_value(result.on("floor"), 0.1998249 * pi, "the floor");
}

TEST_P(ThesisVariants, FillAFurnace) {
    SceneFile file;
    file.box("room", glm::vec3(-1), glm::vec3(1), true, file.material(0.5, 1));
    const Solved result = solved(file, slow ? 4000 : 20000, settings_of(GetParam()));
    expect_value(result.everywhere, 2 * pi, "the walls");
}

INSTANTIATE_TEST_SUITE_P(OneByOneAndTogether, ThesisVariants,
                         ::testing::Values(Habits{true, false, false}, Habits{false, true, false},
                                           Habits{false, false, true}, Habits{true, true, true}));

TEST(ThesisCells, AreFlat) {
    const auto steps = [](bool constant) {
        Engine engine(std::make_shared<const Scene>(dark_room().read()), settings_of({constant, false, false}));
        engine.start({20000, {}, {}});
        engine.wait();
        const std::shared_ptr<const Snapshot> bins = engine.snapshot();
        const std::uint32_t root = bins->charts[engine.scene().charts_of("floor")[0]].direct_root;
        float last = -1;
        int count = 0;
        for (std::uint32_t u = 1u << 13; u < 1u << 24; u += 1u << 14) {
            const float value = lookup::look_up(*bins, root, 0u, u, 1u << 23).value.x;
            if (value != last) ++count;
            last = value;
        }
        return count;
    };
    EXPECT_LT(steps(true), 64);
    EXPECT_GT(steps(false), 512);
}

}  // namespace
}  // namespace brewster
