#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace brewster {

/// What a screen shows: red, green, blue, alpha in eight bits each, sRGB, row 0 on top.
struct ScreenImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< 4 width height bytes
};

/// Writes a PNG file, always opaque (alpha is dropped). Throws Error when the file cannot be written.
void write_png(const std::string& path, const ScreenImage& image);

/// Reads a PNG file of any colour type as RGBA. Throws Error when there is none or it cannot be read.
ScreenImage read_png(const std::string& path);

}  // namespace brewster
