#include "display/gathered_light.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "display/gl_context.h"

namespace brewster {

void GatheredLight::upload(const StokesPicture& picture) {
    begin();
    advance(picture, std::numeric_limits<std::size_t>::max());
}

void GatheredLight::make_room(Side& side, std::size_t part, glm::ivec2 size) {
    if (side.sizes[part] == size) return;
    Texture& texture = side.parts[part];
    if (texture.id() == 0) texture = Texture::create();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, size.x, size.y, 0, GL_RGB, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    side.sizes[part] = size;
}

bool GatheredLight::advance(const StokesPicture& picture, std::size_t bytes) {
    Side& side = sides_[1 - shown_];
    const int width = picture.width, height = picture.height;
    const auto row_size = static_cast<std::size_t>(width);
    const std::size_t rows_allowed = std::max<std::size_t>(1, bytes / (row_size * sizeof(glm::vec3)));
    auto left = static_cast<int>(std::min(rows_allowed, static_cast<std::size_t>(part_count * height - rows_done_)));
    std::vector<glm::vec3> rows;
    while (left > 0) {
        const int part = rows_done_ / height, first = rows_done_ % height;
        const int count = std::min(left, height - first);
        const auto plane = static_cast<std::size_t>(part);
        const std::vector<glm::vec3>& pixels = plane < plane_count       ? picture.light[plane]
                                               : part == variance_linear ? picture.variance_of(Plane::s1)
                                               : part == variance_s3     ? picture.variance_of(Plane::s3)
                                               : part == variance_s0     ? picture.variance_of(Plane::s0)
                                                                         : picture.variance_of(Plane::unpolarized);
        make_room(side, plane, {width, height});
        rows.clear();
        for (int row = first; row < first + count; ++row) {  // GL's first row is the lowest
            const std::size_t begin = static_cast<std::size_t>(height - 1 - row) * row_size;
            for (std::size_t i = begin; i < begin + row_size; ++i)
                rows.push_back(part == variance_linear ? glm::max(pixels[i], picture.variance_of(Plane::s2)[i])
                                                       : pixels[i]);
        }
        glBindTexture(GL_TEXTURE_2D, side.parts[plane].id());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, width, count, GL_RGB, GL_FLOAT, rows.data());
        rows_done_ += count;
        left -= count;
    }
    check_gl("upload of a picture");
    if (rows_done_ < part_count * height) return false;
    shown_ = 1 - shown_;
    rows_done_ = 0;
    return true;
}

LightTextures GatheredLight::textures() const {
    LightTextures textures;
    const Side& side = sides_[shown_];
    const auto id = [&](std::size_t part) { return side.parts[part].id(); };
    const auto of = [&](Plane plane) { return id(static_cast<std::size_t>(plane)); };
    textures.polarized = {of(Plane::s0),   of(Plane::s1),       of(Plane::s2),   of(Plane::s3),
                          id(variance_s0), id(variance_linear), id(variance_s3), 0};
    textures.unpolarized.s0 = of(Plane::unpolarized);
    textures.unpolarized.variance_s0 = id(variance_unpolarized);
    return textures;
}

}  // namespace brewster
