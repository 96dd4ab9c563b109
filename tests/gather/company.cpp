#include <gtest/gtest.h>

#include "gather/eye_tracer.h"
#include "gather/gather_test.h"
#include "optics/random_light.h"

/// What a draw sees owes nothing to its company: in lanes or alone, the same bits.
namespace brewster {
namespace {

std::vector<Draw> some_draws(int width, int height, std::size_t count) {
    std::vector<Draw> draws;
    for (std::size_t k = 0; k < count; ++k) {
        const auto pixel = static_cast<std::uint32_t>(k * 7919 % static_cast<std::size_t>(width * height));
        draws.push_back({static_cast<std::uint16_t>(pixel % static_cast<std::uint32_t>(width)),
                         static_cast<std::uint16_t>(pixel / static_cast<std::uint32_t>(width)),
                         {sequence_key(1, pixel, 0), static_cast<std::uint32_t>(k)}});
        if (k % 2 == 1) draws.back().tolerance = 0.02f;
    }
    return draws;
}

/// All numbers of draw i.
std::vector<float> numbers_of(const LevelLight& light, int components, std::size_t i) {
    std::vector<float> numbers;
    for (std::size_t row = 0; row < 3 * static_cast<std::size_t>(components); ++row)
        numbers.push_back(light.stokes[row][i]);
    for (std::size_t band = 0; band < band_count; ++band)
        for (const Rows<3>* rows : {&light.unpolarized, &light.error, &light.polarized_error, &light.unpolarized_error})
            numbers.push_back((*rows)[band][i]);
    numbers.push_back(light.coarse[i]);
    return numbers;
}

/// One draw at a time fills no lane, so all of its formulas are those of a float; 512 together are lanes but for a few.
TEST(EyeTracer, ADrawAloneHasTheSameBitsAsInCompany) {
    for (const char* name : {"cornell-box", "gloss-lab", "sphere-lab", "shop-window", "waveplates"}) {
        const auto scene = scene_of_assets(name);
        const auto bins = solved_bins(scene, 20'000);
        const EyeScene eye_scene(*scene);
        const Camera& camera = scene->cameras.front();
        const std::vector<Draw> draws = some_draws(64, 48, light_test_scale == 1 ? 512 : 120);
        EyeTracer tracer;
        const auto together = std::make_unique<LevelLight>(), alone = std::make_unique<LevelLight>();
        tracer.trace(eye_scene, *bins, camera, 64, 48, draws, *together);
        int different = 0;
        for (std::size_t i = 0; i < draws.size(); ++i) {
            tracer.trace(eye_scene, *bins, camera, 64, 48, std::span(&draws[i], 1), *alone);
            different += numbers_of(*alone, eye_scene.components, 0) != numbers_of(*together, eye_scene.components, i);
        }
        EXPECT_EQ(different, 0) << name;
        // The control: other numbers see other light.
        std::vector<Draw> others = draws;
        for (Draw& draw : others) ++draw.numbers.key;
        tracer.trace(eye_scene, *bins, camera, 64, 48, others, *alone);
        EXPECT_NE(numbers_of(*alone, eye_scene.components, 7), numbers_of(*together, eye_scene.components, 7)) << name;
    }
}

}  // namespace
}  // namespace brewster
