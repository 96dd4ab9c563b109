#include "display/read_light.h"

#include <glad/gl.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

/// RGB of a rectangle, rows from the top.
class Reader {
  public:
    Reader(int rows, glm::ivec2 low, glm::ivec2 high)
        : framebuffer_(Framebuffer::create()), low_(low.x, rows - high.y), size_(high - low) {}

    /// How many draws the sums of a world hold.
    std::vector<float> draws(const LightTextures::World& world) const {
        std::vector<float> counts;
        for (const glm::vec4 texel : texels(world.s0)) counts.push_back(std::max(texel.a, 1.0f));
        return counts;
    }

    std::vector<glm::vec3> mean(GLuint texture, const std::vector<float>& draws) const {
        std::vector<glm::vec3> pixels;
        for (const glm::vec4 texel : texels(texture)) pixels.push_back(glm::vec3(texel) / draws[pixels.size()]);
        return pixels;
    }

  private:
    std::vector<glm::vec4> texels(GLuint texture) const {
        const std::size_t count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
        std::vector<glm::vec4> pixels(count, glm::vec4(0.0f));
        if (texture == 0) return pixels;
        std::vector<float> values(4 * count);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(low_.x, low_.y, size_.x, size_.y, GL_RGBA, GL_FLOAT, values.data());
        const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 0; x < width; ++x) {
                const float* at = &values[4 * ((height - 1 - y) * width + x)];
                pixels[y * width + x] = glm::vec4(at[0], at[1], at[2], at[3]);
            }
        }
        return pixels;
    }

    Framebuffer framebuffer_;
    glm::ivec2 low_, size_;
};

/// Of the mean that is shown: what the bins and what the draws lend it.
std::vector<glm::vec3> variance_of(const Reader& reader, const LightTextures::World& world,
                                   const std::vector<float>& draws, const std::vector<glm::vec3>& mean) {
    std::vector<glm::vec3> variance = reader.mean(world.variance_s0, draws);
    if (world.squares_s0 == 0) return variance;
    const std::vector<glm::vec3> squares = reader.mean(world.squares_s0, draws);
    for (std::size_t i = 0; i < variance.size(); ++i)
        if (draws[i] > 1) variance[i] += glm::max(squares[i] - mean[i] * mean[i], glm::vec3(0.0f)) / (draws[i] - 1);
    return variance;
}

}  // namespace

StokesPicture read_light(const LightTextures& light, int rows, glm::ivec2 low, glm::ivec2 high) {
    BREWSTER_CHECK(low.x >= 0 && low.y >= 0 && high.x > low.x && high.y > low.y && high.y <= rows, "a rectangle");
    const Reader reader(rows, low, high);
    StokesPicture picture(high.x - low.x, high.y - low.y);
    const LightTextures::World &world = light.polarized, &other = light.unpolarized;
    const std::vector<float> draws = reader.draws(world), other_draws = reader.draws(other);
    picture.draws = static_cast<double>(draws.front());
    picture.of(Plane::s0) = reader.mean(world.s0, draws);
    picture.of(Plane::s1) = reader.mean(world.s1, draws);
    picture.of(Plane::s2) = reader.mean(world.s2, draws);
    picture.of(Plane::s3) = reader.mean(world.s3, draws);
    picture.variance_of(Plane::s0) = variance_of(reader, world, draws, picture.of(Plane::s0));
    picture.variance_of(Plane::s1) = picture.variance_of(Plane::s2) = reader.mean(world.variance_linear, draws);
    picture.variance_of(Plane::s3) = reader.mean(world.variance_s3, draws);
    picture.of(Plane::unpolarized) = reader.mean(other.s0, other_draws);
    picture.variance_of(Plane::unpolarized) = variance_of(reader, other, other_draws, picture.of(Plane::unpolarized));
    check_gl("reading the picture");
    return picture;
}

}  // namespace brewster
