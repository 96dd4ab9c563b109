#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/settling_picture.h"
#include "bins/snapshot.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace brewster {

/// Follows rays from the eye beside the window while nothing moves, at the lowest priority: to full_draws as fast as it
/// can, all that comes after in a twelfth of the time: up to most_draws, and the same anew once the photons have doubled.
/// Draws come in powers of two, tile by tile; each doubling reads the newest bins, but what was begun is brought to
/// full_draws first where bins have become so much better that it would have to be dropped; only first draws begin again
/// where they have become far better meanwhile. All calls return at once; a
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

    /// Tiles of what is wanted that have become better, each once; at most so many, others wait for the next call.
    std::vector<GatheredTile> take(std::size_t most);
    /// Some wait.
    bool has_more() const { return has_more_; }

  private:
    struct Wish {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Snapshot> bins;
        Camera camera;
        int width = 0, height = 0;
        std::uint64_t number = 0;
    };
    struct Eye;

    void work(const std::stop_token& quit);
    void gather(const Wish& wish);
    void offer(const Wish& wish, int tile, std::uint64_t photons, bool first);
    bool asked_to_stop();

    std::unique_ptr<Eye> eye_;       ///< the worker's own
    std::optional<Wish> presented_;  ///< the window's own: what it asked for last
    std::uint64_t wishes_ = 0;       ///< the same: how many
    bool has_more_ = false;

    std::mutex mutex_;
    std::condition_variable_any work_to_do_;
    std::optional<Wish> wish_;                       ///< guarded; what the worker is to do next
    std::shared_ptr<const Snapshot> newest_;         ///< guarded; bins of what it does now
    std::atomic<std::uint64_t> newest_photons_ = 0;  ///< of newest_
    std::atomic<bool> stop_ = false, at_leisure_ = false, photons_fly_ = true;

    // Apart, since the threads that draw offer a tile every few milliseconds: the window never waits for one of them that
    // was pushed aside, and looks again later.
    std::mutex tiles_mutex_;
    std::map<int, GatheredTile> tiles_;                ///< guarded; the newest of each
    std::uint64_t tiles_wish_ = 0;                     ///< guarded; the number of the wish they belong to
    std::chrono::steady_clock::time_point last_wake_;  ///< guarded

    std::jthread worker_;
};

}  // namespace brewster
