#include "scene/texture.h"

#include <gtest/gtest.h>

#include <string>

namespace brewster {
namespace {

// Three texels by two: red rises with the column, green with the row, alpha with both.
SurfaceTexture three_by_two() {
    std::vector<std::uint8_t> texels;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column)
            for (const int byte : {100 * column, 200 * row, 0, 40 * column + 80 * row})
                texels.push_back(static_cast<std::uint8_t>(byte));
    return {3, 2, std::make_shared<const std::vector<std::uint8_t>>(texels), Wrap::repeat, Wrap::repeat, true};
}

TEST(Texture, SrgbIsDecoded) {
    EXPECT_FLOAT_EQ(linear_of_srgb(0), 0.0f);
    EXPECT_FLOAT_EQ(linear_of_srgb(255), 1.0f);
    EXPECT_NEAR(linear_of_srgb(10), 10.0 / 255 / 12.92, 1e-8);
    EXPECT_NEAR(linear_of_srgb(188), 0.502886, 1e-6);  // ((188/255 + 0.055) / 1.055)^2.4
}

TEST(Texture, TheFirstTexelIsTheUpperLeft) {
    const SurfaceTexture texture = three_by_two();
    EXPECT_EQ(texture_at(texture, {0.1f, 0.1f}), glm::vec4(0));
    EXPECT_FLOAT_EQ(texture_at(texture, {0.9f, 0.1f}).x, linear_of_srgb(200));
    EXPECT_FLOAT_EQ(texture_at(texture, {0.1f, 0.9f}).y, linear_of_srgb(200));
    EXPECT_FLOAT_EQ(texture_at(texture, {0.9f, 0.9f}).w, 160.0f / 255);
}

TEST(Texture, RowsGoOnAsTheSamplerSays) {
    SurfaceTexture texture = three_by_two();
    const auto column = [&](float u) {
        const float red = texture_at(texture, {u, 0.25f}).x;
        return red == 0 ? 0 : red == linear_of_srgb(100) ? 1 : 2;
    };
    const auto columns = [&](Wrap wrap) {
        texture.wrap_u = wrap;
        std::string seen;
        for (int i = -4; i < 8; ++i) seen += std::to_string(column((static_cast<float>(i) + 0.5f) / 3.0f));
        return seen;
    };
    EXPECT_EQ(columns(Wrap::repeat), "201201201201");
    EXPECT_EQ(columns(Wrap::mirror), "221001221001");
    EXPECT_EQ(columns(Wrap::clamp), "000001222222");
}

TEST(Texture, LinearBetweenTexelsInLinearLight) {
    SurfaceTexture texture = three_by_two();
    texture.nearest = false;
    EXPECT_FLOAT_EQ(texture_at(texture, {0.5f / 3, 0.25f}).x, 0.0f);
    EXPECT_NEAR(texture_at(texture, {1.0f / 3, 0.25f}).x, 0.5f * linear_of_srgb(100), 1e-6);
    EXPECT_NEAR(texture_at(texture, {1.25f / 3, 0.5f}).x, 0.75f * linear_of_srgb(100), 1e-6);
    EXPECT_NEAR(texture_at(texture, {1.25f / 3, 0.5f}).y, 0.5f * linear_of_srgb(200), 1e-6);
    EXPECT_NEAR(texture_at(texture, {0.0f, 0.25f}).x, 0.5f * linear_of_srgb(200), 1e-6);  // across the seam
}

TEST(Texture, Means) {
    const glm::dvec4 mean = texture_mean(three_by_two());
    EXPECT_NEAR(mean.x, static_cast<double>(linear_of_srgb(100) + linear_of_srgb(200)) / 3, 1e-7);
    EXPECT_NEAR(mean.y, static_cast<double>(linear_of_srgb(200)) / 2, 1e-7);
    EXPECT_NEAR(mean.w, 80.0 / 255, 1e-9);
    EXPECT_NEAR(texture_byte_mean(three_by_two()).x, 100.0 / 255, 1e-9);
}

}  // namespace
}  // namespace brewster
