#include "reference/reference.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "image/blocks.h"

namespace brewster {
namespace {

constexpr std::uint64_t pilot = 16;  // samples

/// Mean over blocks of 8 x 8 pixels of the variance of S0 over its square, dark ones being judged against a tenth of the
/// mean. (A pixel after so few samples is too noisy: one that was hit by a single photon is as bright as its noise.)
double relative_variance(const Image& part_pixels, const Image& whole_pixels) {
    const Image part = block_means(part_pixels, 8).image, whole = block_means(whole_pixels, 8).image;
    double sum = 0;
    for (int band = 0; band < band_count; ++band) {
        const double floor = 0.1 * mean_of(whole, 0, band).mean;
        const std::vector<float>&variance = part.channel(variance_channel(0, band)),
              &value = whole.channel(stokes_channel(0, band));
        for (std::size_t i = 0; i < value.size(); ++i) {
            const double scale = static_cast<double>(value[i]) * static_cast<double>(value[i]) + floor * floor;
            if (scale > 0) sum += static_cast<double>(variance[i]) / scale;
        }
    }
    return sum / static_cast<double>(band_count * whole.pixel_count());
}

/// Where n samples and n r photons cost about n (1 + r) and leave the variance (a + b/r)/n, r = sqrt(b/a) is best. In
/// powers of two; the optimum is flat.
double best_photons_a_sample(double camera_variance, double light_variance) {
    constexpr double least = 1.0 / 4, most = 32;
    if (!(light_variance > 0)) return least;
    if (!(camera_variance > 0)) return most;
    const double exponent = std::round(0.5 * std::log2(light_variance / camera_variance));
    return std::clamp(std::exp2(exponent), least, most);
}

}  // namespace

Reference::Reference(const Scene& scene, const Camera& camera, int width, int height, bool polarized,
                     std::uint64_t seed, unsigned threads)
    : surroundings_(scene),
      camera_tracer_(surroundings_, camera, width, height, {polarized, camera_tracer_owns, seed}),
      light_tracer_(surroundings_, camera, width, height, {polarized, light_tracer_owns, seed}),
      threads_(threads) {
    BREWSTER_CHECK(threads >= 1 && width >= 1 && height >= 1, std::to_string(threads));
}

void Reference::add_samples(std::uint64_t count) {
    const std::uint64_t first = samples() < pilot ? std::min(count, pilot - samples()) : 0;
    if (first > 0) {
        trace(first, 1);
        if (samples() == pilot && light_tracer_.any()) {
            Image by_camera(camera_tracer_.sums().width(), camera_tracer_.sums().height()), by_light = by_camera;
            camera_tracer_.sums().add_to(by_camera, samples());
            light_tracer_.sums().add_to(by_light, photons());
            const Image both = picture();
            photons_a_sample_ =
                best_photons_a_sample(relative_variance(by_camera, both), relative_variance(by_light, both));
        }
    }
    if (count > first) trace(count - first, photons_a_sample_);
}

void Reference::trace(std::uint64_t samples, double photons_a_sample) {
    camera_tracer_.add_samples(samples, threads_);
    // Of the whole run, so that rounding does not depend on how it was cut.
    const std::uint64_t after = this->samples(), of_pilot = std::min(after, pilot);
    const auto pixels = static_cast<double>(camera_tracer_.sums().size());
    const auto wanted = static_cast<std::uint64_t>(
        pixels * (static_cast<double>(of_pilot) + static_cast<double>(after - of_pilot) * photons_a_sample));
    light_tracer_.add_photons(wanted - light_tracer_.photons(), threads_);
}

Image Reference::picture() const {
    Image picture(camera_tracer_.sums().width(), camera_tracer_.sums().height());
    camera_tracer_.sums().add_to(picture, samples());
    light_tracer_.sums().add_to(picture, photons());
    return picture;
}

PictureMean mean_of(const Image& picture, int component, int band) {
    double sum = 0, variance = 0;
    for (const float x : picture.channel(stokes_channel(component, band))) sum += static_cast<double>(x);
    for (const float v : picture.channel(variance_channel(component, band))) variance += static_cast<double>(v);
    const auto pixels = static_cast<double>(picture.pixel_count());
    return {sum / pixels, std::sqrt(variance) / pixels};
}

}  // namespace brewster
