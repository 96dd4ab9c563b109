#include "display/read_light.h"

#include <glad/gl.h>

#include "display/gl_object.h"
#include "gl_test.h"

namespace brewster {
namespace {

constexpr int width = 7, height = 5;

class ReadLightTest : public GlTest {
  protected:
    /// (column, row from the top, value) in every pixel, and an alpha.
    static Texture texture(float value, float alpha = 1) {
        std::vector<float> texels;
        for (int y = height - 1; y >= 0; --y)
            for (int x = 0; x < width; ++x)
                texels.insert(texels.end(), {static_cast<float>(x), static_cast<float>(y), value, alpha});
        Texture made = Texture::create();
        glBindTexture(GL_TEXTURE_2D, made.id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
        return made;
    }
};

TEST_F(ReadLightTest, FetchesTheVeryPixelsAsMeans) {
    const Texture s0 = texture(40, 4), s2 = texture(8), squares = texture(1000), variance = texture(4);
    LightTextures light;
    light.polarized.s0 = s0.id();
    light.polarized.s2 = s2.id();
    light.polarized.squares_s0 = squares.id();
    light.polarized.variance_s0 = variance.id();
    const StokesPicture read = read_light(light, height, {2, 1}, {5, 3});
    ASSERT_EQ(read.width, 3);
    ASSERT_EQ(read.height, 2);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) {
            const auto at = static_cast<std::size_t>(3 * y + x);
            EXPECT_EQ(read.of(Plane::s0)[at],
                      glm::vec3(static_cast<float>(x + 2) / 4, static_cast<float>(y + 1) / 4, 10));
            EXPECT_EQ(read.of(Plane::s2)[at].z, 2);
            EXPECT_EQ(read.of(Plane::s1)[at].z, 0);
            // 1 of the bins; of the draws (250 - 10 * 10) / 3.
            EXPECT_FLOAT_EQ(read.variance_of(Plane::s0)[at].z, 1 + 50);
        }
    }
}

}  // namespace
}  // namespace brewster
