#include "reference/stokes_sums.h"

#include <algorithm>

#include "base/check.h"

namespace brewster {

void StokesSums::add_to(Image& picture, std::uint64_t count) const {
    BREWSTER_CHECK(picture.width() == width_ && picture.height() == height_, std::to_string(picture.width()));
    if (count == 0) return;
    const auto n = static_cast<double>(count);
    for (int component = 0; component < 4; ++component)
        for (int band = 0; band < band_count; ++band) {
            for (const std::string& name : {stokes_channel(component, band), variance_channel(component, band)})
                if (!picture.has(name)) picture.add_channel(name);
            std::vector<float>& means = picture.channel(stokes_channel(component, band));
            std::vector<float>& variances = picture.channel(variance_channel(component, band));
            const auto j = static_cast<std::size_t>(4 * band + component);
            for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
                const double mean = pixels_[pixel].sum[j] / n;
                const double spread = std::max(pixels_[pixel].squares[j] / n - mean * mean, 0.0);
                means[pixel] = static_cast<float>(static_cast<double>(means[pixel]) + mean);
                variances[pixel] =
                    static_cast<float>(static_cast<double>(variances[pixel]) + spread / std::max(n - 1, 1.0));
            }
        }
}

}  // namespace brewster
