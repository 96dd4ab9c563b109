#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "base/error.h"

namespace brewster {
namespace {

using Pixels = std::vector<float>;

const Pixels* find(const Image& image, const std::string& channel) {
    return image.has(channel) ? &image.channel(channel) : nullptr;
}

const Pixels* find_stokes(const Image& image, int component, int band) {
    const Pixels* pixels = find(image, stokes_channel(component, band));
    if (pixels || component > 0) return pixels;
    return find(image, std::string(1, band_letters[static_cast<std::size_t>(band)]));
}

std::vector<std::size_t> selected_pixels(std::size_t count, std::span<const std::uint8_t> mask) {
    std::vector<std::size_t> selected;
    for (std::size_t i = 0; i < count; ++i) {
        if (mask.empty() || mask[i]) selected.push_back(i);
    }
    return selected;
}

double mean(const Pixels& pixels, const std::vector<std::size_t>& region) {
    double sum = 0;
    for (const std::size_t i : region) sum += pixels[i];
    return sum / static_cast<double>(region.size());
}

void require_finite(const Pixels& pixels, const std::vector<std::size_t>& region, const char* which) {
    const auto broken =
        std::count_if(region.begin(), region.end(), [&](std::size_t i) { return !std::isfinite(pixels[i]); });
    if (broken == 0) return;
    throw Error(std::to_string(broken) + " pixels are not finite numbers", std::string(which) + " picture",
                "leave them out of the region or mend the picture");
}

struct Channels {
    const Pixels& a;
    const Pixels& b;
    const Pixels* variance_a;
    const Pixels* variance_b;
};

// The least value that so many percent of the values stay below or at.
std::array<double, 4> percentiles_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    std::array<double, 4> result{};
    for (std::size_t k = 0; k < result.size(); ++k) {
        const std::size_t percent = static_cast<std::size_t>(difference_percentiles[k]);
        result[k] = values[(percent * values.size() + 99) / 100 - 1];
    }
    return result;
}

BandDifference difference(const Channels& channels, double floor, const std::vector<std::size_t>& region) {
    const double n = static_cast<double>(region.size());
    std::vector<double> relative;
    relative.reserve(region.size());
    double squares = 0, relative_squares = 0, bias = 0, variance = 0;
    std::array<double, 3> within{};
    for (const std::size_t i : region) {
        const double a = channels.a[i], b = channels.b[i];
        const double noise = channels.variance_b ? static_cast<double>((*channels.variance_b)[i]) : 0.0;
        const double scale = b * b + floor * floor;
        squares += (a - b) * (a - b);
        relative.push_back(scale > 0 ? std::abs(a - b) / std::sqrt(scale) : 0.0);
        if (scale > 0) relative_squares += ((a - b) * (a - b) - noise) / scale;
        bias += a - b;
        const double both = noise + (channels.variance_a ? static_cast<double>((*channels.variance_a)[i]) : 0.0);
        variance += both;
        for (const int errors : {1, 2, 3})
            if ((a - b) * (a - b) <= errors * errors * both) within[static_cast<std::size_t>(errors - 1)] += 1 / n;
    }
    BandDifference result;
    result.mean_a = mean(channels.a, region);
    result.mean_b = mean(channels.b, region);
    result.rmse = std::sqrt(squares / n);
    result.rmse_beyond_noise = std::sqrt(std::max(0.0, (squares - variance) / n));
    result.relative_rmse = std::sqrt(std::max(0.0, relative_squares / n));
    result.bias = bias / n;
    result.percentiles = percentiles_of(std::move(relative));
    if (channels.variance_a || channels.variance_b) {
        result.bias_standard_error = std::sqrt(variance) / n;
        result.within = within;
    }
    return result;
}

}  // namespace

PictureDifference compare(const Image& a, const Image& b, std::span<const std::uint8_t> mask, double epsilon) {
    BREWSTER_CHECK(epsilon > 0, std::to_string(epsilon));
    BREWSTER_CHECK(mask.empty() || mask.size() == a.pixel_count(), std::to_string(mask.size()));
    if (a.width() != b.width() || a.height() != b.height()) {
        const auto size = [](const Image& i) { return std::to_string(i.width()) + " x " + std::to_string(i.height()); };
        throw Error("one is " + size(a) + " pixels, the other " + size(b), "pictures to compare",
                    "draw both in the same size");
    }
    const std::vector<std::size_t> region = selected_pixels(a.pixel_count(), mask);
    if (region.empty()) throw Error("no pixel is left to compare", "region", "choose one that the camera sees");

    PictureDifference result;
    result.pixels = region.size();
    for (int component = 0; component < 4; ++component) {
        std::array<BandDifference, 3> bands;
        bool complete = true;
        for (int band = 0; band < 3; ++band) {
            const Pixels* pixels_a = find_stokes(a, component, band);
            const Pixels* pixels_b = find_stokes(b, component, band);
            const Pixels* s0 = find_stokes(b, 0, band);
            complete = pixels_a && pixels_b;
            if (!complete) break;
            require_finite(*pixels_a, region, "first");
            require_finite(*pixels_b, region, "second");
            const std::string variance = variance_channel(component, band);
            const Channels channels{*pixels_a, *pixels_b, find(a, variance), find(b, variance)};
            if (channels.variance_a) require_finite(*channels.variance_a, region, "first");
            if (channels.variance_b) require_finite(*channels.variance_b, region, "second");
            bands[static_cast<std::size_t>(band)] = difference(channels, epsilon * mean(*s0, region), region);
        }
        if (complete) result.components[static_cast<std::size_t>(component)] = bands;
        if (!complete && component == 0) {
            throw Error("one has neither S0.R S0.G S0.B nor R G B", "pictures to compare",
                        "give pictures with radiance");
        }
    }
    result.polarization = compare_polarization(a, b, mask);
    return result;
}

}  // namespace brewster
