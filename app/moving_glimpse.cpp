#include "app/moving_glimpse.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/clock.h"
#include "base/threads.h"

namespace brewster {
namespace {

constexpr double seconds_a_frame = 0.03;
constexpr double largest_shrinking = 8;  // of each side; coarser tells nothing

}  // namespace

void MovingGlimpse::open(std::shared_ptr<const Scene> scene) {
    wanted_ = std::move(scene);
}

bool MovingGlimpse::same(const Sight& a, const Sight& b) {
    return same_pose(a.camera, b.camera) && a.width == b.width && a.height == b.height && a.photons == b.photons &&
           a.generation == b.generation;
}

void MovingGlimpse::clear(Picture& picture) {
    seen_.reset();
    picture.clear_glimpse();
}

void MovingGlimpse::show(Picture& picture, const Camera& camera, std::uint64_t generation) {
    if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        glimpse_ = making_.get();
    const bool ready = glimpse_ && glimpse_->scene() == wanted_;
    if (!ready && !making_.valid())
        making_ = std::async(std::launch::async, [scene = wanted_] { return std::make_unique<Glimpse>(scene); });
    const Snapshot* bins = picture.bins();
    if (!ready || !bins || !glimpse_->any()) return clear(picture);

    const int width = picture.width(), height = picture.height();
    const Sight sight{camera, width, height, bins->photons, generation};
    if (seen_ && same(*seen_, sight)) return;
    seen_ = sight;
    const double pixels = static_cast<double>(width) * height;
    const double shrinking = std::clamp(std::sqrt(pixels * seconds_a_pixel_ / seconds_a_frame), 1.0, largest_shrinking);
    const auto side = [&](int whole) { return std::max(1, static_cast<int>(std::lround(whole / shrinking))); };
    const double begin = seconds_now();
    const GlimpsePicture seen = glimpse_->see(*bins, camera, side(width), side(height), thread_count());
    picture.show_glimpse(seen.width, seen.height, seen.chart, seen.light);
    // Of all pixels: how many need a ray's light is a matter of the view, which changes little by little.
    seconds_a_pixel_ = std::max(1e-9, (seconds_now() - begin) / static_cast<double>(seen.chart.size()));
}

}  // namespace brewster
