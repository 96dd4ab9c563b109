#include "image/statistics.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "base/units.h"

namespace brewster {
namespace {

/// Sum over the region; 0 for a channel that is not there.
double sum(const Image& picture, const std::string& channel, std::span<const std::uint8_t> mask) {
    if (!picture.has(channel)) return 0;
    const std::vector<float>& pixels = picture.channel(channel);
    double total = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (mask.empty() || mask[i]) total += static_cast<double>(pixels[i]);
    return total;
}

}  // namespace

PictureStatistics statistics(const Image& picture, std::span<const std::uint8_t> mask) {
    BREWSTER_CHECK(mask.empty() || mask.size() == picture.pixel_count(), std::to_string(mask.size()));
    PictureStatistics result;
    result.pixels = mask.empty() ? picture.pixel_count()
                                 : static_cast<std::size_t>(std::count_if(mask.begin(), mask.end(),
                                                                          [](std::uint8_t chosen) { return chosen; }));
    if (result.pixels == 0) throw Error("the region holds no pixel", "picture", "choose a mesh that can be seen");
    const double n = static_cast<double>(result.pixels);
    for (int band = 0; band < 3; ++band) {
        BandStatistics& of = result.bands[static_cast<std::size_t>(band)];
        for (int component = 0; component < 4; ++component) {
            const auto c = static_cast<std::size_t>(component);
            std::string channel = stokes_channel(component, band);
            if (component == 0 && !picture.has(channel))
                channel = std::string(1, band_letters[static_cast<std::size_t>(band)]);
            if (component == 0) picture.channel(channel);  // says what is missing
            of.mean[c] = sum(picture, channel, mask) / n;
            of.standard_error[c] = std::sqrt(sum(picture, variance_channel(component, band), mask)) / n;
        }
        const double linear = std::hypot(of.mean[1], of.mean[2]);
        if (linear > 0) of.aolp = degrees(0.5 * std::atan2(of.mean[2], of.mean[1]));
        if (of.mean[0] <= 0) continue;
        of.dolp = linear / of.mean[0];
        of.docp = std::abs(of.mean[3]) / of.mean[0];
        of.dop = std::hypot(linear, of.mean[3]) / of.mean[0];
    }
    return result;
}

}  // namespace brewster
