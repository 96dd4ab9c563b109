#include "display/gathered_light.h"

#include <algorithm>
#include <glm/common.hpp>

#include "display/gl_context.h"

namespace brewster {
namespace {

/// GL's first row is the lowest.
std::vector<glm::vec3> bottom_up(const std::vector<glm::vec3>& pixels, int width) {
    std::vector<glm::vec3> rows;
    rows.reserve(pixels.size());
    for (auto row = pixels.end(); row != pixels.begin();) {
        row -= width;
        rows.insert(rows.end(), row, row + width);
    }
    return rows;
}

}  // namespace

void GatheredLight::upload(const StokesPicture& picture) {
    const auto send = [&](Texture& texture, const std::vector<glm::vec3>& pixels) {
        if (texture.id() == 0) texture = Texture::create();
        glBindTexture(GL_TEXTURE_2D, texture.id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, picture.width, picture.height, 0, GL_RGB, GL_FLOAT,
                     bottom_up(pixels, picture.width).data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    };
    for (std::size_t k = 0; k < plane_count; ++k) send(light_[k], picture.light[k]);
    std::vector<glm::vec3> linear = picture.variance_of(Plane::s1);
    const std::vector<glm::vec3>& s2 = picture.variance_of(Plane::s2);
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = glm::max(linear[i], s2[i]);
    send(variance_s0_, picture.variance_of(Plane::s0));
    send(variance_linear_, linear);
    send(variance_s3_, picture.variance_of(Plane::s3));
    send(variance_unpolarized_, picture.variance_of(Plane::unpolarized));
    check_gl("upload of a picture");
}

LightTextures GatheredLight::textures() const {
    LightTextures textures;
    const auto id = [&](Plane plane) { return light_[static_cast<std::size_t>(plane)].id(); };
    textures.polarized = {id(Plane::s0),
                          id(Plane::s1),
                          id(Plane::s2),
                          id(Plane::s3),
                          variance_s0_.id(),
                          variance_linear_.id(),
                          variance_s3_.id(),
                          0,
                          1};
    textures.unpolarized.s0 = id(Plane::unpolarized);
    textures.unpolarized.variance_s0 = variance_unpolarized_.id();
    return textures;
}

}  // namespace brewster
