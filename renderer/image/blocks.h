#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace brewster {

/// A picture of block means, and which of its blocks hold a selected pixel.
struct Blocks {
    Image image;
    std::vector<std::uint8_t> mask;
};

/// Means over blocks of side x side pixels, so that noise steps back behind what two pictures really differ in. Blocks
/// at the right and lower border may be smaller. Channels V0.R .. V3.B become variances of the means, pixels taken as
/// independent. `mask` selects pixels by non-zero, empty takes all; a block without any is zero. side >= 1.
Blocks block_means(const Image& image, int side, std::span<const std::uint8_t> mask = {});

}  // namespace brewster
