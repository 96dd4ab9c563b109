#include "display/tone.h"

#include <gtest/gtest.h>

#include <random>

#include "image/exr.h"

namespace brewster {
namespace {

TEST(Tone, CurveIsLinearInTheDarksAndMonotoneToWhite) {
    for (const float x : {0.0f, 0.001f, 0.1f, 0.25f}) EXPECT_FLOAT_EQ(tone::shoulder(x), x);
    float before = 0;
    for (float x = 1e-4f; x < 1e4f; x *= 1.01f) {
        const float level = tone::shoulder(x);
        EXPECT_GT(level, before) << x;
        EXPECT_LT(level, 1.0f) << x;
        before = level;
    }
    EXPECT_GT(tone::shoulder(1e4f), 0.9999f);
}

TEST(Tone, ShoulderBeginsWithTheSlopeOfTheKnee) {
    const float step = 1e-3f;
    EXPECT_NEAR((tone::shoulder(0.25f + step) - tone::shoulder(0.25f)) / step, 1.0f, 3e-3f);
    EXPECT_FLOAT_EQ(tone::shoulder(2.5f), 0.8125f);  // t = 3
}

TEST(Tone, EveryBandGrowsWithExposure) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 colour(uniform(random), uniform(random), uniform(random));
        glm::vec3 before(0.0f);
        for (float exposure = -10; exposure < 8; exposure += 0.25f) {
            const glm::vec3 code = tone::screen_colour(colour, exposure);
            for (int band = 0; band < 3; ++band) {
                EXPECT_GT(code[band], before[band]);
                EXPECT_LE(code[band], 1.0f);
            }
            before = code;
        }
    }
}

TEST(Tone, HueStaysAndTheVeryBrightTurnsWhite) {
    const glm::vec3 orange(1.0f, 0.5f, 0.1f);
    const glm::vec3 dark = tone::tone_mapped(0.1f * orange);
    EXPECT_NEAR(dark.y / dark.x, 0.5f, 1e-6f);
    EXPECT_NEAR(dark.z / dark.x, 0.1f, 1e-6f);
    const glm::vec3 middle = tone::tone_mapped(orange);
    EXPECT_GT(middle.x, middle.y);
    EXPECT_GT(middle.y, middle.z);
    const glm::vec3 glaring = tone::tone_mapped(1000.0f * orange);
    EXPECT_GT(glaring.z, 0.99f);
    EXPECT_EQ(tone::tone_mapped(glm::vec3(0.0f)), glm::vec3(0.0f));
}

TEST(Tone, SrgbCodesFollowTheStandard) {
    EXPECT_FLOAT_EQ(tone::srgb_code(0.0f), 0.0f);
    EXPECT_NEAR(tone::srgb_code(0.214041140f), 0.5f, 1e-6f);  // middle of the code
    EXPECT_NEAR(tone::srgb_code(0.0031308f), 0.04045f, 1e-6f);
    EXPECT_NEAR(tone::srgb_code(1.0f), 1.0f, 1e-6f);
}

Image grey(const std::vector<float>& values) {
    Image image(static_cast<int>(values.size()), 1);
    for (int band = 0; band < 3; ++band) image.add_channel(stokes_channel(0, band)) = values;
    return image;
}

TEST(AutoExposure, LogMeanBecomesMiddleGrey) {
    EXPECT_FLOAT_EQ(auto_exposure(grey({0.18f, 0.18f})), 0.0f);
    EXPECT_FLOAT_EQ(auto_exposure(grey({0.18f / 4, 0.18f * 16})), -1.0f);
    EXPECT_FLOAT_EQ(auto_exposure(grey({0.18f * 8, 0, 0, 0})), -3.0f);  // black is no light to adapt to
    EXPECT_FLOAT_EQ(auto_exposure(grey({0, 0})), 0.0f);
    Image blue = grey({0.01f});
    blue.channel("S0.B") = {0.18f * 2};
    EXPECT_FLOAT_EQ(auto_exposure(blue), -1.0f);
}

// A pixel that hardly anything has reached yet must not drag the mean: it counts as 1e-4 of the mean.
TEST(AutoExposure, OneStrayPixelHardlyMatters) {
    std::vector<float> values(1000, 0.18f);
    values[0] = 1e-30f;
    EXPECT_NEAR(auto_exposure(grey(values)), 0.0f, 0.11f);
}

// A room of 3 cd/m2 with a sun spot of 1000 on 5 % of it: the room lands in the linear part, the spot below white.
TEST(AutoExposure, WideContrastKeepsBothEnds) {
    std::vector<float> values(1000, 3.0f);
    std::fill_n(values.begin(), 50, 1000.0f);
    const float exposure = auto_exposure(grey(values));
    const float room = tone::screen_colour(glm::vec3(3.0f), exposure).x;
    EXPECT_GT(room, 0.35f);
    EXPECT_LT(room, 0.55f);
    EXPECT_LT(tone::screen_colour(glm::vec3(1000.0f), exposure).x, 0.999f);
    EXPECT_GT(tone::screen_colour(glm::vec3(1000.0f), exposure).x - tone::screen_colour(glm::vec3(300.0f), exposure).x,
              2.0f / 255);
}

// The lamp of the Cornell box has 17 cd/m2, its back wall 0.2: the wall must come out as a light grey, neither the lamp
// as the only thing seen nor the wall as white.
TEST(AutoExposure, CornellBoxShowsItsWalls) {
    const Image front = read_exr(BREWSTER_SOURCE_DIR "/tests/images/peer/cornell-box-front.exr");
    const float exposure = auto_exposure(front);
    EXPECT_GT(exposure, 0.0f);
    EXPECT_LT(exposure, 3.0f);
    const std::size_t wall = 96 * 30 + 48;
    const glm::vec3 radiance(front.channel("S0.R")[wall], front.channel("S0.G")[wall], front.channel("S0.B")[wall]);
    const glm::vec3 code = tone::screen_colour(radiance, exposure);
    EXPECT_GT(code.x, 0.5f);
    EXPECT_LT(code.x, 0.85f);
    EXPECT_GT(tone::screen_colour({17, 12, 4}, exposure).z, 0.85f);
}

}  // namespace
}  // namespace brewster
