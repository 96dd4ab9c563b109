#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace brewster {

inline constexpr std::uint32_t no_texture = 0xffffffffu;

enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// A picture that colours a surface. Coordinates as in glTF: (0, 0) is the upper left corner of the first texel.
struct SurfaceTexture {
    int width = 0, height = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> texels;  ///< RGBA, colours in sRGB, rows from the top
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool nearest = false;  ///< no interpolation between texels
};

/// IEC 61966-2-1: the linear value of an 8-bit sRGB number.
float linear_of_srgb(std::uint8_t value);

/// Linear colour and alpha at a place: the texel's, or interpolated between the nearest four in linear light.
glm::vec4 texture_at(const SurfaceTexture& texture, glm::vec2 place);

/// Linear mean over all texels.
glm::dvec4 texture_mean(const SurfaceTexture& texture);

/// The mean of the bytes themselves over 255, for pictures that hold numbers instead of colours.
glm::dvec4 texture_byte_mean(const SurfaceTexture& texture);

}  // namespace brewster
