#include "scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brewster {
namespace {

std::array<float, 256> srgb_table() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < 256; ++i) {
        const double c = static_cast<double>(i) / 255.0;
        table[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return table;
}

// The texel that stands for number i of an endless row. `i` is whole.
std::size_t wrapped(float i, int count, Wrap wrap) {
    const auto n = static_cast<float>(count);
    float inside = std::clamp(i, 0.0f, n - 1.0f);
    if (wrap == Wrap::repeat) inside = i - n * std::floor(i / n);
    if (wrap == Wrap::mirror) {
        const float twice = i - 2.0f * n * std::floor(i / (2.0f * n));
        inside = twice < n ? twice : 2.0f * n - 1.0f - twice;
    }
    return static_cast<std::size_t>(std::clamp(inside, 0.0f, n - 1.0f));
}

glm::vec4 texel(const SurfaceTexture& texture, float column, float row) {
    const std::size_t place =
        4 * (wrapped(row, texture.height, texture.wrap_v) * static_cast<std::size_t>(texture.width) +
             wrapped(column, texture.width, texture.wrap_u));
    const std::uint8_t* bytes = texture.texels->data() + place;
    return {linear_of_srgb(bytes[0]), linear_of_srgb(bytes[1]), linear_of_srgb(bytes[2]),
            static_cast<float>(bytes[3]) / 255.0f};
}

template <class Value>
glm::dvec4 mean(const SurfaceTexture& texture, const Value& value) {
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < texture.texels->size(); ++i)
        sum[static_cast<int>(i % 4)] += value((*texture.texels)[i], i % 4 == 3);
    return sum / (static_cast<double>(texture.texels->size()) / 4.0);
}

}  // namespace

float linear_of_srgb(std::uint8_t value) {
    static const std::array<float, 256> table = srgb_table();
    return table[value];
}

glm::vec4 texture_at(const SurfaceTexture& texture, glm::vec2 place) {
    const float x = place.x * static_cast<float>(texture.width), y = place.y * static_cast<float>(texture.height);
    if (texture.nearest) return texel(texture, std::floor(x), std::floor(y));
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const float s = x - 0.5f - left, t = y - 0.5f - top;
    const glm::vec4 above = (1.0f - s) * texel(texture, left, top) + s * texel(texture, left + 1.0f, top);
    const glm::vec4 below = (1.0f - s) * texel(texture, left, top + 1.0f) + s * texel(texture, left + 1.0f, top + 1.0f);
    return (1.0f - t) * above + t * below;
}

glm::dvec4 texture_mean(const SurfaceTexture& texture) {
    return mean(texture, [](std::uint8_t byte, bool alpha) {
        return alpha ? static_cast<double>(byte) / 255.0 : static_cast<double>(linear_of_srgb(byte));
    });
}

glm::dvec4 texture_byte_mean(const SurfaceTexture& texture) {
    return mean(texture, [](std::uint8_t byte, bool) { return static_cast<double>(byte) / 255.0; });
}

}  // namespace brewster
