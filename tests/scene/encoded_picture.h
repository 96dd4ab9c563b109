#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace brewster {

/// RGBA of the pixel (x, y), row 0 on top.
using PixelColor = std::function<std::array<std::uint8_t, 4>(int, int)>;

/// The bytes of a PNG or, without its alpha, of a JPEG file.
std::string png_bytes(int width, int height, const PixelColor& color);
std::string jpeg_bytes(int width, int height, const PixelColor& color);

}  // namespace brewster
