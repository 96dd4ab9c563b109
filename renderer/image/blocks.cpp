#include "image/blocks.h"

#include "base/check.h"

namespace brewster {

Blocks block_means(const Image& image, int side, std::span<const std::uint8_t> mask) {
    BREWSTER_CHECK(side >= 1, std::to_string(side));
    BREWSTER_CHECK(mask.empty() || mask.size() == image.pixel_count(), std::to_string(mask.size()));
    const int columns = (image.width() + side - 1) / side, rows = (image.height() + side - 1) / side;
    Blocks blocks{Image(columns, rows), {}};
    blocks.image.attributes = image.attributes;
    const auto block_of = [&](std::size_t pixel) {
        const std::size_t width = static_cast<std::size_t>(image.width()), s = static_cast<std::size_t>(side);
        return pixel / width / s * static_cast<std::size_t>(columns) + pixel % width / s;
    };
    std::vector<double> counts(blocks.image.pixel_count());
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
        if (mask.empty() || mask[i]) counts[block_of(i)] += 1;
    for (const double count : counts) blocks.mask.push_back(count > 0);

    std::vector<double> sums(counts.size());
    for (const std::string& name : image.channel_names()) {
        const std::vector<float>& pixels = image.channel(name);
        sums.assign(counts.size(), 0.0);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (mask.empty() || mask[i]) sums[block_of(i)] += static_cast<double>(pixels[i]);
        std::vector<float>& means = blocks.image.add_channel(name);
        for (std::size_t b = 0; b < sums.size(); ++b)
            if (counts[b] > 0)
                means[b] = static_cast<float>(sums[b] / counts[b] / (is_variance_channel(name) ? counts[b] : 1.0));
    }
    return blocks;
}

}  // namespace brewster
