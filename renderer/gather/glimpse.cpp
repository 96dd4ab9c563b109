#include "gather/glimpse.h"

#include <algorithm>

#include "base/check.h"
#include "base/threads.h"
#include "gather/first_look.h"

namespace brewster {
namespace {

constexpr float always = 1e6f;  // of any share that tells

}  // namespace

Glimpse::Glimpse(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)), eye_(*scene_) {
    for (const Chart& chart : scene_->charts) beyond_.push_back(scene_->materials[chart.material].beyond_bins());
    any_ = std::find(beyond_.begin(), beyond_.end(), true) != beyond_.end();
}

GlimpsePicture Glimpse::see(const Snapshot& bins, const Camera& camera, int width, int height, unsigned threads) {
    BREWSTER_CHECK(width > 0 && height > 0 && width < (1 << 16) && height < (1 << 16),
                   std::to_string(width) + " x " + std::to_string(height));
    GlimpsePicture picture;
    picture.width = width;
    picture.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    picture.chart.assign(pixels, no_chart);
    for (auto& plane : picture.light) plane.assign(pixels, glm::vec3(0.0f));
    while (tracers_.size() < threads) tracers_.push_back(std::make_unique<EyeTracer>());
    on_threads(height, threads,
               [&](int row, unsigned thread) { see_row(*tracers_[thread], bins, camera, row, picture); });
    picture.followed =
        pixels - static_cast<std::size_t>(std::count(picture.chart.begin(), picture.chart.end(), no_chart));
    return picture;
}

void Glimpse::see_row(EyeTracer& tracer, const Snapshot& bins, const Camera& camera, int row,
                      GlimpsePicture& picture) const {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width);
    std::vector<Ray> rays;
    std::vector<Draw> all, draws;
    const PictureRays eye_rays(camera, picture.width, picture.height);
    for (int column = 0; column < picture.width; ++column) {
        const auto pixel = static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(column);
        Draw draw{static_cast<std::uint16_t>(column), static_cast<std::uint16_t>(row), {sequence_key(1, pixel, 0), 0}};
        draw.eagerness = always;
        const auto place = number_pair<float>(draw.numbers.key, draw.numbers.index, place_dimension);
        rays.push_back({camera.position,
                        eye_rays.direction(static_cast<float>(column) + place[0], static_cast<float>(row) + place[1])});
        all.push_back(draw);
    }
    std::vector<Hit> hits(rays.size());
    eye_.rays.intersect(rays, hits);
    look_past_backs(eye_.rays, rays, hits);
    std::vector<std::size_t> pixels;
    const auto seen = std::make_unique<LevelLight>();
    const auto flush = [&] {
        tracer.trace(eye_, bins, camera, picture.width, picture.height, draws, *seen);
        const auto s = [&](std::size_t value, std::size_t i) { return seen->stokes[value][i]; };
        for (std::size_t i = 0; i < draws.size(); ++i) {
            const std::size_t pixel = pixels[i];
            for (std::size_t plane = 0; plane < static_cast<std::size_t>(eye_.components); ++plane)
                picture.light[plane][pixel] = {s(3 * plane, i), s(3 * plane + 1, i), s(3 * plane + 2, i)};
            // With one component both worlds are the same.
            const auto& off = seen->unpolarized;
            picture.light[static_cast<std::size_t>(Plane::unpolarized)][pixel] =
                eye_.components > 1 ? glm::vec3(off[0][i], off[1][i], off[2][i]) : picture.light[0][pixel];
        }
        draws.clear();
        pixels.clear();
    };
    for (std::size_t column = 0; column < all.size(); ++column) {
        const std::uint32_t chart = hits[column].chart;
        if (chart == no_chart || !beyond_[chart]) continue;
        picture.chart[first + column] = chart;
        draws.push_back(all[column]);
        pixels.push_back(first + column);
        if (draws.size() == eye_batch) flush();
    }
    if (!draws.empty()) flush();
}

}  // namespace brewster
