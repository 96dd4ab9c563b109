#include "image/png.h"

#include <stb_image_write.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/check.h"
#include "base/error.h"
#include "image/decode.h"

namespace brewster {
namespace {

constexpr const char* writing_advice = "check that the folder exists, is writable and has room";

std::vector<std::uint8_t> without_alpha(const ScreenImage& image) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    }
    return rgb;
}

}  // namespace

void write_png(const std::string& path, const ScreenImage& image) {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    BREWSTER_CHECK(image.width > 0 && image.height > 0 && image.rgba.size() == 4 * pixels, path);
    std::ofstream file(path, std::ios::binary);
    if (!file) throw Error(std::string("cannot be written, ") + std::strerror(errno), path, writing_advice);
    const auto append = [](void* context, void* bytes, int count) {
        static_cast<std::ofstream*>(context)->write(static_cast<const char*>(bytes), count);
    };
    const std::vector<std::uint8_t> rgb = without_alpha(image);
    const int encoded =
        stbi_write_png_to_func(append, &file, image.width, image.height, 3, rgb.data(), 3 * image.width);
    file.close();
    if (!encoded || !file) throw Error("could not be written to its end", path, writing_advice);
}

ScreenImage read_png(const std::string& path) {
    constexpr const char* advice = "give the path of a PNG file";
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(std::string("cannot be read, ") + std::strerror(errno), path, advice);
    const std::vector<unsigned char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::optional<EncodedSize> size = encoded_size(bytes);
    std::optional<std::vector<std::uint8_t>> rgba = decode_rgba(bytes);
    if (!size || !rgba) throw Error("cannot be read, its bytes are no picture", path, advice);
    return {size->width, size->height, std::move(*rgba)};
}

}  // namespace brewster
