#include "display/gathered_light.h"

#include <glm/common.hpp>
#include <vector>

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

/// The radiances, whose alpha says which pixels have come.
bool counts_draws(std::size_t part) {
    return part == static_cast<std::size_t>(Plane::s0) || part == static_cast<std::size_t>(Plane::unpolarized);
}

}  // namespace

bool GatheredLight::make_room(int width, int height) {
    if (size_ != glm::ivec2(width, height)) made_ = 0;
    size_ = {width, height};
    if (made_ == part_count) return true;
    const std::size_t part = made_++;
    Texture& texture = parts_[part];
    const bool counts = counts_draws(part);
    if (sizes_[part] != size_ || counts) {
        if (texture.id() == 0) texture = Texture::create();
        std::vector<glm::vec4> nothing;
        if (counts) nothing.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::vec4(0.0f));
        glBindTexture(GL_TEXTURE_2D, texture.id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT,
                     counts ? nothing.data() : nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        sizes_[part] = size_;
        check_gl("room for a picture");
    }
    return made_ == part_count;
}

void GatheredLight::put(const StokesPicture& part, int left, int top) {
    BREWSTER_CHECK(
        made_ == part_count && left >= 0 && top >= 0 && left + part.width <= size_.x && top + part.height <= size_.y,
        "a part");
    std::vector<glm::vec4> values;
    for (std::size_t i = 0; i < part_count; ++i) {
        const std::vector<glm::vec3>& pixels = i < plane_count        ? part.light[i]
                                               : i == variance_linear ? part.variance_of(Plane::s1)
                                               : i == variance_s3     ? part.variance_of(Plane::s3)
                                               : i == variance_s0     ? part.variance_of(Plane::s0)
                                                                      : part.variance_of(Plane::unpolarized);
        values.clear();
        for (int row = part.height - 1; row >= 0; --row) {  // GL's first row is the lowest
            for (int column = 0; column < part.width; ++column) {
                const auto p = static_cast<std::size_t>(row) * static_cast<std::size_t>(part.width) +
                               static_cast<std::size_t>(column);
                const glm::vec3 value =
                    i == variance_linear ? glm::max(pixels[p], part.variance_of(Plane::s2)[p]) : pixels[p];
                values.emplace_back(value, 1.0f);
            }
        }
        glBindTexture(GL_TEXTURE_2D, parts_[i].id());
        glTexSubImage2D(GL_TEXTURE_2D, 0, left, size_.y - top - part.height, part.width, part.height, GL_RGBA, GL_FLOAT,
                        values.data());
    }
    check_gl("upload of a picture");
}

void GatheredLight::upload(const StokesPicture& picture) {
    clear();
    while (!make_room(picture.width, picture.height)) continue;
    put(picture, 0, 0);
}

LightTextures GatheredLight::textures() const {
    LightTextures textures;
    const auto id = [&](std::size_t part) { return parts_[part].id(); };
    const auto of = [&](Plane plane) { return id(static_cast<std::size_t>(plane)); };
    textures.polarized = {of(Plane::s0),   of(Plane::s1),       of(Plane::s2),   of(Plane::s3),
                          id(variance_s0), id(variance_linear), id(variance_s3), 0};
    textures.unpolarized.s0 = of(Plane::unpolarized);
    textures.unpolarized.variance_s0 = id(variance_unpolarized);
    return textures;
}

}  // namespace brewster
