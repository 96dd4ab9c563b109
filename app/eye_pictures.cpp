#include "app/eye_pictures.h"

#include <chrono>
#include <thread>

#include "app/interrupt.h"
#include "app/numbers.h"
#include "app/pictures.h"
#include "base/error.h"
#include "base/log.h"

namespace brewster {

EyePictures::EyePictures(const Scene& scene, std::shared_ptr<const Snapshot> bins, const ShotOptions& options)
    : options_(options),
      gather_(std::make_shared<EyeScene>(scene), options.solve.engine.seed),
      threads_(options.solve.engine.threads > 0 ? options.solve.engine.threads
                                                : std::max(std::thread::hardware_concurrency(), 1u)) {
    gather_.show(std::move(bins));
}

const StokesPicture& EyePictures::of(const Camera& camera) {
    using Clock = std::chrono::steady_clock;
    if (pictures_ > 0 && camera.name == camera_) return picture_;
    const PictureSize size = size_for(camera, options_.size);
    gather_.look(camera, size.width, size.height);
    const auto start = Clock::now();
    {
        const InterruptScope ctrl_c;
        gather_.draw(static_cast<std::uint32_t>(options_.samples), threads_, [&] { return ctrl_c.interrupted(); });
        if (ctrl_c.interrupted())
            log_warning("stopped by a signal; going on with " + significant(gather_.draws()) + " draws a pixel");
    }
    sums_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    if (gather_.draws() == 0) throw Error("nothing was drawn", camera.name, "give it more time");
    sums_.draws += gather_.draws();
    sums_.coarse_share += gather_.coarse_share();
    ++pictures_;
    camera_ = camera.name;
    return picture_ = gather_.picture();
}

GatherResult EyePictures::result() const {
    const int n = std::max(pictures_, 1);
    return {sums_.draws / n, sums_.seconds, sums_.coarse_share / n};
}

}  // namespace brewster
