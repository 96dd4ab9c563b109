#include "image/png.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

#include "base/check.h"
#include "base/error.h"

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
    ScreenImage image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> bytes(
        stbi_load(path.c_str(), &image.width, &image.height, &channels, 4), stbi_image_free);
    if (!bytes)
        throw Error(std::string("cannot be read, ") + stbi_failure_reason(), path, "give the path of a PNG file");
    const std::size_t count = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.assign(bytes.get(), bytes.get() + count);
    return image;
}

}  // namespace brewster
