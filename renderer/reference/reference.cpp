#include "reference/reference.h"

#include <cmath>

#include "base/check.h"

namespace brewster {

Reference::Reference(const Scene& scene, const Camera& camera, int width, int height, bool polarized,
                     std::uint64_t seed, unsigned threads)
    : surroundings_(scene),
      camera_tracer_(surroundings_, camera, width, height, {polarized, camera_tracer_owns, seed}),
      light_tracer_(surroundings_, camera, width, height, {polarized, light_tracer_owns, seed}),
      threads_(threads) {
    BREWSTER_CHECK(threads >= 1 && width >= 1 && height >= 1, std::to_string(threads));
}

void Reference::add_samples(std::uint64_t count) {
    camera_tracer_.add_samples(count, threads_);
    light_tracer_.add_photons(count * camera_tracer_.sums().size(), threads_);
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
