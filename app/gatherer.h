#pragma once
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "bins/snapshot.h"
#include "image/stokes_picture.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace brewster {

/// A picture of rays from the eye, and of how many photons the bins were at its first draws.
struct GatheredPicture {
    std::shared_ptr<const StokesPicture> light;
    std::uint64_t photons = 0;
};

/// Follows rays from the eye beside the window while nothing moves, at the lowest priority: to full_draws as fast as it
/// can, all that comes after in a twelfth of the time: up to most_draws, and the same anew once the photons have doubled.
/// Pictures come in powers of two of draws; each doubling reads the newest bins, but what was begun is brought to
/// full_draws first where bins have become so much better that it would have to be dropped. All calls return at once; a
/// picture that is no longer wanted is left within milliseconds.
class Gatherer {
  public:
    static constexpr std::uint32_t full_draws = 64, most_draws = 1024;  ///< per pixel, on the mean

    Gatherer();
    ~Gatherer();
    Gatherer(const Gatherer&) = delete;
    Gatherer& operator=(const Gatherer&) = delete;

    /// What to gather: goes on where it is the same but for more photons, begins anew where it is not. Where no
    /// `photons_fly` any more, full_draws are enough.
    void want(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Snapshot>& bins,
              const Camera& camera, int width, int height, bool photons_fly);
    void stop();

    /// The newest picture of what is wanted, once; none if it has not become better.
    std::optional<GatheredPicture> take();

  private:
    struct Wish {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Snapshot> bins;
        Camera camera;
        int width = 0, height = 0;
    };
    struct Eye;

    void work(const std::stop_token& quit);
    void gather(const Wish& wish);
    bool asked_to_stop();

    std::unique_ptr<Eye> eye_;       ///< the worker's own
    std::optional<Wish> presented_;  ///< the window's own: what it asked for last

    std::mutex mutex_;
    std::condition_variable_any work_to_do_;
    std::optional<Wish> wish_;                ///< guarded; what the worker is to do next
    std::shared_ptr<const Snapshot> newest_;  ///< guarded; bins of what it does now
    std::optional<GatheredPicture> ready_;    ///< guarded
    std::atomic<bool> stop_ = false, at_leisure_ = false, photons_fly_ = true;
    std::jthread worker_;
};

}  // namespace brewster
