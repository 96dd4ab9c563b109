#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace brewster {

/// Width and height of an encoded picture.
struct EncodedSize {
    int width = 0, height = 0;

    std::size_t texels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// The size that a PNG or JPEG announces; nothing if it is neither.
std::optional<EncodedSize> encoded_size(std::span<const unsigned char> encoded);

/// Red, green, blue, alpha per pixel, 8 bits each as the file holds them (16 bits are rounded), rows from the top.
/// Nothing if it is neither PNG nor JPEG or broken, or unpacks to much more than the pixels it announces.
std::optional<std::vector<std::uint8_t>> decode_rgba(std::span<const unsigned char> encoded);

}  // namespace brewster
