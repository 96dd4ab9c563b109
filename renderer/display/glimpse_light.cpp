#include "display/glimpse_light.h"

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

/// GL's first row is the lowest.
template <class Pixel>
void send(Texture& texture, const std::vector<Pixel>& pixels, int width, int height, GLint stored, GLenum format,
          GLenum type) {
    std::vector<Pixel> rows;
    rows.reserve(pixels.size());
    for (auto row = pixels.end(); row != pixels.begin();) {
        row -= width;
        rows.insert(rows.end(), row, row + width);
    }
    if (texture.id() == 0) texture = Texture::create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, stored, width, height, 0, format, type, rows.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

void GlimpseLight::upload(int width, int height, const std::vector<std::uint32_t>& chart,
                          const std::array<std::vector<glm::vec3>, plane_count>& light) {
    BREWSTER_CHECK(width > 0 && height > 0 && chart.size() == light[0].size(), std::to_string(chart.size()));
    width_ = width;
    height_ = height;
    send(chart_, chart, width, height, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
    for (std::size_t plane = 0; plane < plane_count; ++plane)
        send(light_[plane], light[plane], width, height, GL_RGB32F, GL_RGB, GL_FLOAT);
    check_gl("upload of a glimpse");
}

void GlimpseLight::bind(const Program& program, int first_unit, int frame_width, int frame_height) const {
    constexpr std::array<const char*, plane_count> names = {"glimpse_s0", "glimpse_s1", "glimpse_s2", "glimpse_s3",
                                                            "glimpse_unpolarized"};
    // Samplers of different types must not share a unit, even where nothing is looked up.
    const auto bind_to = [&](const char* name, int unit, const Texture& texture) {
        if (!program.has(name)) return;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, texture.id());
        program.set(name, unit);
    };
    bind_to("glimpse_charts", first_unit, chart_);
    for (std::size_t plane = 0; plane < plane_count; ++plane)
        bind_to(names[plane], first_unit + 1 + static_cast<int>(plane), light_[plane]);
    if (!program.has("glimpse_scale")) return;
    program.set("glimpse_scale", shows() ? glm::vec2(static_cast<float>(width_) / static_cast<float>(frame_width),
                                                     static_cast<float>(height_) / static_cast<float>(frame_height))
                                         : glm::vec2(0.0f));
}

}  // namespace brewster
