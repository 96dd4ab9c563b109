#include "scene/encoded_picture.h"

#include <stb_image_write.h>

#include <vector>

namespace brewster {
namespace {

std::vector<std::uint8_t> pixels(int width, int height, const PixelColor& color) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t byte : color(x, y)) rgba.push_back(byte);
    return rgba;
}

void append(void* into, void* bytes, int count) {
    static_cast<std::string*>(into)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(count));
}

}  // namespace

std::string png_bytes(int width, int height, const PixelColor& color) {
    std::string bytes;
    stbi_write_png_to_func(append, &bytes, width, height, 4, pixels(width, height, color).data(), 4 * width);
    return bytes;
}

std::string jpeg_bytes(int width, int height, const PixelColor& color) {
    std::string bytes;
    stbi_write_jpg_to_func(append, &bytes, width, height, 4, pixels(width, height, color).data(), 95);
    return bytes;
}

}  // namespace brewster
