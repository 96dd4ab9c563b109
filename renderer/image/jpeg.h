#pragma once
#include <optional>
#include <span>

#include "image/decode.h"

namespace brewster {

/// The same as in decode.h, for JPEG alone (decode.h asks here).
std::optional<EncodedSize> jpeg_size(std::span<const unsigned char> encoded);
std::optional<std::vector<std::uint8_t>> decode_jpeg(std::span<const unsigned char> encoded);

}  // namespace brewster
