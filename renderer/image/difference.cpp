#include "image/difference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "base/error.h"

namespace brewster {
namespace {

void require_equal_sizes(const Image& a, const Image& b) {
    if (a.width() == b.width() && a.height() == b.height()) return;
    const auto size = [](const Image& i) { return std::to_string(i.width()) + " x " + std::to_string(i.height()); };
    throw Error("one is " + size(a) + " pixels, the other " + size(b), "pictures to compare",
                "draw both in the same size");
}

std::vector<double> band_mean(const Image& image) {
    std::vector<double> mean(image.pixel_count());
    for (int band = 0; band < 3; ++band) {
        const std::string plain(1, band_letters[static_cast<std::size_t>(band)]), stokes = stokes_channel(0, band);
        const std::vector<float>& pixels = image.channel(image.has(stokes) ? stokes : plain);
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<double>(pixels[i]) / 3.0;
    }
    return mean;
}

// sRGB codes. Both ends are as far from white, so that neither sign looks larger.
constexpr std::array<double, 3> orange = {214, 96, 10}, blue = {20, 100, 200};

}  // namespace

Image difference_image(const Image& a, const Image& b) {
    require_equal_sizes(a, b);
    Image result(a.width(), a.height());
    for (const std::string& name : a.channel_names()) {
        if (!b.has(name)) continue;
        const float sign = is_variance_channel(name) ? 1.0f : -1.0f;
        const std::vector<float>&x = a.channel(name), &y = b.channel(name);
        std::vector<float>& pixels = result.add_channel(name);
        for (std::size_t i = 0; i < x.size(); ++i) pixels[i] = x[i] + sign * y[i];
    }
    if (result.channel_names().empty())
        throw Error("they have no channel in common", "pictures to compare", "give pictures with radiance");
    return result;
}

ScreenImage difference_map(const Image& a, const Image& b, double epsilon, double full) {
    BREWSTER_CHECK(full > 0 && epsilon >= 0, std::to_string(full) + " " + std::to_string(epsilon));
    require_equal_sizes(a, b);
    const std::vector<double> x = band_mean(a), y = band_mean(b);
    double mean = 0;
    for (const double value : y) mean += value / static_cast<double>(y.size());
    ScreenImage map{a.width(), a.height(), std::vector<std::uint8_t>(4 * x.size(), 255)};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double scale = std::hypot(y[i], epsilon * mean);
        const double relative = scale > 0 ? (x[i] - y[i]) / scale : 0.0;
        const double share = std::min(std::abs(relative) / full, 1.0);
        const std::array<double, 3>& end = relative > 0 ? orange : blue;
        for (std::size_t band = 0; band < 3; ++band)
            map.rgba[4 * i + band] = static_cast<std::uint8_t>(std::lround(255 + share * (end[band] - 255)));
    }
    return map;
}

}  // namespace brewster
