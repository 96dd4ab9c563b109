#include "display/read_light.h"

#include <glad/gl.h>

#include <algorithm>
#include <glm/common.hpp>

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

/// RGB of a rectangle, rows from the top.
class Reader {
  public:
    Reader(int rows, glm::ivec2 low, glm::ivec2 high)
        : framebuffer_(Framebuffer::create()), low_(low.x, rows - high.y), size_(high - low) {}

    std::vector<glm::vec3> read(GLuint texture, float scale) const {
        const std::size_t count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
        std::vector<glm::vec3> pixels(count, glm::vec3(0.0f));
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
                pixels[y * width + x] = scale * glm::vec3(at[0], at[1], at[2]);
            }
        }
        return pixels;
    }

  private:
    Framebuffer framebuffer_;
    glm::ivec2 low_, size_;
};

/// Of the mean that is shown: what the bins and what the draws lend it.
std::vector<glm::vec3> variance_of(const Reader& reader, const LightTextures::World& world,
                                   const std::vector<glm::vec3>& mean) {
    std::vector<glm::vec3> variance = reader.read(world.variance_s0, 1 / world.draws);
    if (world.squares_s0 == 0 || world.draws <= 1) return variance;
    const std::vector<glm::vec3> squares = reader.read(world.squares_s0, 1 / world.draws);
    for (std::size_t i = 0; i < variance.size(); ++i)
        variance[i] += glm::max(squares[i] - mean[i] * mean[i], glm::vec3(0.0f)) / (world.draws - 1);
    return variance;
}

}  // namespace

StokesPicture read_light(const LightTextures& light, int rows, glm::ivec2 low, glm::ivec2 high) {
    BREWSTER_CHECK(low.x >= 0 && low.y >= 0 && high.x > low.x && high.y > low.y && high.y <= rows, "a rectangle");
    const Reader reader(rows, low, high);
    StokesPicture picture(high.x - low.x, high.y - low.y);
    const LightTextures::World& world = light.polarized;
    const float scale = 1 / world.draws;
    picture.draws = static_cast<double>(world.draws);
    picture.of(Plane::s0) = reader.read(world.s0, scale);
    picture.of(Plane::s1) = reader.read(world.s1, scale);
    picture.of(Plane::s2) = reader.read(world.s2, scale);
    picture.of(Plane::s3) = reader.read(world.s3, scale);
    picture.variance_of(Plane::s0) = variance_of(reader, world, picture.of(Plane::s0));
    picture.variance_of(Plane::s1) = picture.variance_of(Plane::s2) = reader.read(world.variance_linear, scale);
    picture.variance_of(Plane::s3) = reader.read(world.variance_s3, scale);
    picture.of(Plane::unpolarized) = reader.read(light.unpolarized.s0, 1 / light.unpolarized.draws);
    picture.variance_of(Plane::unpolarized) = variance_of(reader, light.unpolarized, picture.of(Plane::unpolarized));
    check_gl("reading the picture");
    return picture;
}

}  // namespace brewster
