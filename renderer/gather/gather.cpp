#include "gather/gather.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/threads.h"

namespace brewster {
namespace {

/// Of a pixel's n-th draw: about what as many rays in the bins' place would err by. A ray's light scatters by some half of
/// all light; bins that err by less than its mean is known are the better ones.
float tolerance_of(std::uint32_t n) {
    constexpr float scatter = 0.5f, least = 0.02f;
    if (n < Gather::plain_draws) return std::numeric_limits<float>::infinity();
    return std::max(least, scatter / std::sqrt(static_cast<float>(n + 1)));
}

}  // namespace

Gather::Gather(std::shared_ptr<const EyeScene> scene, std::uint64_t seed) : scene_(std::move(scene)), seed_(seed) {}

void Gather::show(std::shared_ptr<const Snapshot> bins) {
    BREWSTER_CHECK(bins && bins->charts.size() == scene_->scene.charts.size(), scene_->scene.name);
    const bool other_solution = bins_ && bins->photons < bins_->photons;
    bins_ = std::move(bins);
    if (other_solution || bins_->photons / 2 > first_photons_) forget();
}

void Gather::look(const Camera& camera, int width, int height) {
    BREWSTER_CHECK(width > 0 && height > 0 && width < (1 << 16) && height < (1 << 16),
                   std::to_string(width) + " x " + std::to_string(height));
    const bool same = width == width_ && height == height_ && same_pose(camera, camera_);
    camera_ = camera;
    width_ = width;
    height_ = height;
    if (!same) forget();
}

void Gather::forget() {
    pixels_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), {});
    importance_.clear();
    first_photons_ = bins_ ? bins_->photons : 0;
}

bool Gather::draw(std::uint32_t mean_draws, unsigned threads, const StopAsked& stop, const TileDrawn& drawn) {
    BREWSTER_CHECK(bins_ && width_ > 0, "show and look first");
    if (mean_draws < 2 * pilot_draws)
        return draw_to(std::vector<std::uint32_t>(pixels_.size(), mean_draws), threads, stop, drawn);
    if (importance_.empty()) {
        if (!draw_to(std::vector<std::uint32_t>(pixels_.size(), pilot_draws), threads, stop, {})) return false;
        importance_ = importance_of(pixels_, width_, height_);
    }
    return draw_to(shared_out_draws(importance_, pilot_draws, mean_draws), threads, stop, drawn);
}

bool Gather::draw_to(const std::vector<std::uint32_t>& wanted, unsigned threads, const StopAsked& stop,
                     const TileDrawn& drawn) {
    while (tracers_.size() < threads) tracers_.push_back(std::make_unique<EyeTracer>());
    on_threads(tiles(), threads, [&](int tile, unsigned thread) {
        if (!stop() && draw_tile(*tracers_[thread], tile, wanted, stop) && drawn) drawn(tile);
    });
    return !stop();
}

int Gather::tiles() const {
    return (width_ + tile_pixels - 1) / tile_pixels * ((height_ + tile_pixels - 1) / tile_pixels);
}

Gather::TileBounds Gather::bounds(int tile) const {
    const int columns = (width_ + tile_pixels - 1) / tile_pixels;
    const int left = tile % columns * tile_pixels, top = tile / columns * tile_pixels;
    return {left, top, std::min(left + tile_pixels, width_), std::min(top + tile_pixels, height_)};
}

PictureTile Gather::tile(int index) const {
    const TileBounds at = bounds(index);
    std::vector<PixelSum> pixels;
    for (int row = at.top; row < at.bottom; ++row) {
        const PixelSum* first = pixels_.data() + static_cast<std::ptrdiff_t>(row) * width_;
        pixels.insert(pixels.end(), first + at.left, first + at.right);
    }
    return {at.left, at.top, picture_of(pixels, at.right - at.left, at.bottom - at.top)};
}

bool Gather::draw_tile(EyeTracer& tracer, int tile, const std::vector<std::uint32_t>& wanted, const StopAsked& stop) {
    struct Share {
        std::size_t pixel, first, count;
    };
    std::vector<Draw> draws;
    std::vector<Share> shares;
    const auto seen = std::make_unique<LevelLight>();
    const auto alone = std::make_unique<BinsAlone>();
    const auto flush = [&] {
        tracer.trace(*scene_, *bins_, camera_, width_, height_, draws, *seen, alone.get());
        for (const Share& share : shares)
            add_draws(*seen, *alone, scene_->components, share.first, share.count, pixels_[share.pixel]);
        draws.clear();
        shares.clear();
    };
    const TileBounds at = bounds(tile);
    for (int row = at.top; row < at.bottom; ++row) {
        for (int column = at.left; column < at.right; ++column) {
            const std::size_t pixel =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
            std::uint32_t next = pixels_[pixel].draws;
            const auto key = [&](std::uint32_t replica) {
                return sequence_key(seed_, static_cast<std::uint32_t>(pixel), replica);
            };
            const std::array<std::uint32_t, 2> keys = {key(0), key(1)};
            while (next < wanted[pixel]) {
                shares.push_back({pixel, draws.size(), 0});
                for (; next < wanted[pixel] && draws.size() < eye_batch; ++next, ++shares.back().count) {
                    Draw& draw = draws.emplace_back();
                    draw.column = static_cast<std::uint16_t>(column);
                    draw.row = static_cast<std::uint16_t>(row);
                    draw.numbers = {keys[next % 2], next / 2};
                    draw.goes_wide = next >= plain_draws;
                    draw.tolerance = tolerance_of(next);
                    draw.reads_bins = next < draws_of_bins_alone;
                }
                if (draws.size() < eye_batch) continue;
                flush();
                if (stop()) return false;
            }
        }
    }
    if (!draws.empty()) flush();
    return true;
}

double Gather::draws() const {
    double sum = 0;
    for (const PixelSum& pixel : pixels_) sum += pixel.draws;
    return pixels_.empty() ? 0 : sum / static_cast<double>(pixels_.size());
}

StokesPicture Gather::picture() const {
    return picture_of(pixels_, width_, height_);
}

PictureError Gather::error() const {
    return error_of(pixels_);
}

double Gather::coarse_share() const {
    double coarse = 0, all = 0;
    for (const PixelSum& pixel : pixels_) {
        if (pixel.draws == 0) continue;
        coarse += static_cast<double>(pixel.coarse) / pixel.draws;
        for (std::size_t band = 0; band < band_count; ++band)
            all += static_cast<double>(pixel.mean(plane_values - band_count + band)) / band_count;
    }
    return all > 0 ? coarse / all : 0;
}

}  // namespace brewster
