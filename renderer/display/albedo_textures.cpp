#include "display/albedo_textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"

namespace brewster {
namespace {

GLint wrap_of(Wrap wrap) {
    return wrap == Wrap::clamp ? GL_CLAMP_TO_EDGE : wrap == Wrap::mirror ? GL_MIRRORED_REPEAT : GL_REPEAT;
}

// 16 bits hold linear light as finely as the file's 8 bits of sRGB.
std::vector<std::uint16_t> linear_texels(const SurfaceTexture& from) {
    std::array<std::uint16_t, 256> linear{}, alpha{};
    for (std::size_t i = 0; i < 256; ++i) {
        linear[i] = static_cast<std::uint16_t>(std::lround(65535.0f * linear_of_srgb(static_cast<std::uint8_t>(i))));
        alpha[i] = static_cast<std::uint16_t>(257 * i);
    }
    std::vector<std::uint16_t> texels(from.texels->size());
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = i % 4 == 3 ? alpha[(*from.texels)[i]] : linear[(*from.texels)[i]];
    return texels;
}

void fill(const Texture& texture, int width, int height, const std::uint16_t* texels, GLint filter) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, width, height, 0, GL_RGBA, GL_UNSIGNED_SHORT, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

}  // namespace

AlbedoTextures::AlbedoTextures(const Scene& scene) : white_(Texture::create()) {
    GLint longest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
    constexpr std::array<std::uint16_t, 4> one = {65535, 65535, 65535, 65535};
    fill(white_, 1, 1, one.data(), GL_NEAREST);
    for (const SurfaceTexture& from : scene.textures) {
        if (std::max(from.width, from.height) > longest)
            throw Error("a texture of " + std::to_string(from.width) + " x " + std::to_string(from.height) +
                            " pixels is too large for this graphics driver",
                        scene.name, "scale it to at most " + std::to_string(longest) + " a side");
        textures_.push_back(Texture::create());
        fill(textures_.back(), from.width, from.height, linear_texels(from).data(),
             from.nearest ? GL_NEAREST : GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(from.wrap_u));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(from.wrap_v));
    }
}

void AlbedoTextures::bind(const Program& program, const char* uniform, int unit, std::uint32_t texture) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture == no_texture ? white_.id() : textures_[texture].id());
    program.set(uniform, unit);
}

}  // namespace brewster
