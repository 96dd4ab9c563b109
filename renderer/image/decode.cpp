#include "image/decode.h"

#include <cstdlib>
#include <limits>
#include <memory>

#include "image/jpeg.h"

namespace {

// Bytes that one allocation of the decoder may have: a small file can unpack to a thousand times its size.
thread_local std::size_t most_bytes = 0;

void* bounded_allocate(std::size_t bytes) {
    return bytes <= most_bytes ? std::malloc(bytes) : nullptr;
}

void* bounded_reallocate(void* old, std::size_t bytes) {
    return bytes <= most_bytes ? std::realloc(old, bytes) : nullptr;
}

}  // namespace

// A copy of the decoder for its allocations alone.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MALLOC(bytes) bounded_allocate(bytes)
#define STBI_REALLOC(old, bytes) bounded_reallocate(old, bytes)
#define STBI_FREE(old) std::free(old)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace brewster {
namespace {

constexpr std::size_t least_room = std::size_t{1} << 20;

bool is_jpeg(std::span<const unsigned char> encoded) {
    return encoded.size() > 2 && encoded[0] == 0xff && encoded[1] == 0xd8;
}

bool too_long(std::span<const unsigned char> encoded) {
    return encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max());
}

}  // namespace

std::optional<EncodedSize> encoded_size(std::span<const unsigned char> encoded) {
    if (is_jpeg(encoded)) return jpeg_size(encoded);
    EncodedSize size;
    int channels = 0;
    most_bytes = least_room;
    if (too_long(encoded) ||
        !stbi_info_from_memory(encoded.data(), static_cast<int>(encoded.size()), &size.width, &size.height, &channels))
        return {};
    return size;
}

std::optional<std::vector<std::uint8_t>> decode_rgba(std::span<const unsigned char> encoded) {
    if (is_jpeg(encoded)) return decode_jpeg(encoded);
    const std::optional<EncodedSize> size = encoded_size(encoded);
    if (!size) return {};
    most_bytes = least_room + 16 * size->texels();  // 8 bytes a pixel of 16-bit RGBA, and the next power of two
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels, 4),
        std::free);
    if (!pixels) return {};
    return std::vector<std::uint8_t>(pixels.get(), pixels.get() + 4 * size->texels());
}

}  // namespace brewster
