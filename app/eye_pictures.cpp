#include "app/eye_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/clock.h"
#include "app/interrupt.h"
#include "app/numbers.h"
#include "app/pictures.h"
#include "base/error.h"
#include "base/log.h"
#include "base/threads.h"

namespace brewster {
namespace {

constexpr int trial_pixels = 20'000;     // of a picture, about
constexpr double worthwhile = 1.0 / 16;  // of the draws so far; fewer more are not begun
constexpr double negligible = 0.05;      // of the bins' squared error: more draws do not help

bool keep_drawing() {
    return false;
}

}  // namespace

EyePictures::EyePictures(const Scene& scene, const ShotOptions& options)
    : options_(options),
      scene_(std::make_shared<EyeScene>(scene)),
      gather_(scene_, options.solve.engine.seed),
      threads_(thread_count(options.solve.engine.threads)) {}

void EyePictures::show(std::shared_ptr<const Snapshot> bins, const DrawRule& rule, std::size_t cameras) {
    gather_.show(std::move(bins));
    rule_ = rule;
    cameras_left_ = cameras;
}

EyePictures::Trial EyePictures::trial(std::shared_ptr<const Snapshot> bins, std::span<const Camera* const> cameras) {
    Trial trial;
    Gather gather(scene_, options_.solve.engine.seed);
    gather.show(std::move(bins));
    for (const Camera* camera : cameras) {
        const PictureSize size = size_for(*camera, options_.size);
        const double pixels = static_cast<double>(size.width) * size.height;
        const double shrink = std::max(1.0, std::sqrt(pixels / trial_pixels));
        const auto side = [&](int full) { return std::max(1, static_cast<int>(std::lround(full / shrink))); };
        gather.look(*camera, side(size.width), side(size.height));
        const double start = seconds_now();
        gather.draw(Gather::pilot_draws, threads_, keep_drawing);
        const double drawn = static_cast<double>(side(size.width)) * side(size.height);
        trial.draws.seconds += (seconds_now() - start) * pixels / drawn;
        const PictureError error = gather.error();
        trial.draws.error = std::max(trial.draws.error, error.draws);
        trial.bins_error = std::max(trial.bins_error, error.bins);
    }
    return trial;
}

const StokesPicture& EyePictures::of(const Camera& camera) {
    if (pictures_ > 0 && camera.name == camera_) return picture_;
    const PictureSize size = size_for(camera, options_.size);
    gather_.look(camera, size.width, size.height);
    const double start = seconds_now();
    const double end = rule_.end > 0 ? start + (rule_.end - start) / static_cast<double>(cameras_left_) : 0;
    if (cameras_left_ > 1) --cameras_left_;
    {
        const InterruptScope ctrl_c;
        draw([&] { return ctrl_c.interrupted(); }, end);
        if (ctrl_c.interrupted())
            log_warning("stopped by a signal; going on with " + significant(gather_.draws()) + " draws a pixel");
    }
    sums_.seconds += seconds_now() - start;
    if (gather_.draws() == 0) throw Error("nothing was drawn", camera.name, "give it more time");
    sums_.draws += gather_.draws();
    sums_.coarse_share += gather_.coarse_share();
    const PictureError error = gather_.error();
    sums_.error.draws += error.draws;
    sums_.error.bins += error.bins;
    ++pictures_;
    camera_ = camera.name;
    return picture_ = gather_.picture();
}

// By doubling, so that each step leaves a whole picture; the last step is what the time is still enough for. The first
// draw is made in any case.
void EyePictures::draw(const StopAsked& stop, double end) {
    const auto most = static_cast<std::uint32_t>(rule_.samples);
    if (end <= 0 && !rule_.target_error) {
        gather_.draw(most, threads_, stop);
        return;
    }
    const StopAsked stop_in_time = [&] { return stop() || (end > 0 && seconds_now() >= end); };
    for (std::uint32_t wanted = 1, next = 1;; wanted = next) {
        const double before = gather_.draws(), start = seconds_now();
        if (!gather_.draw(wanted, threads_, wanted == 1 ? stop : stop_in_time) || wanted >= most) return;
        const double now = seconds_now();
        if (rule_.target_error && wanted >= Gather::pilot_draws) {
            const PictureError error = gather_.error();
            if (error.draws + error.bins <= *rule_.target_error || error.draws < negligible * error.bins) return;
        }
        next = std::min(2 * wanted, most);
        if (end > 0) {
            const double rate = (gather_.draws() - before) / std::max(now - start, 1e-9);
            const double more = rate * (end - now);
            if (more < worthwhile * wanted) return;
            next = std::min(next, wanted + static_cast<std::uint32_t>(std::min(std::ceil(more), 1e6)));
        }
    }
}

GatherResult EyePictures::result() const {
    const int n = std::max(pictures_, 1);
    return {sums_.draws / n, sums_.seconds, sums_.coarse_share / n, {sums_.error.draws / n, sums_.error.bins / n}};
}

}  // namespace brewster
