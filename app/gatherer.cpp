#include "app/gatherer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/newer_bins.h"
#include "app/window.h"
#include "base/priority.h"
#include "base/threads.h"
#include "gather/gather.h"

namespace brewster {
namespace {

using Clock = std::chrono::steady_clock;

// A picture of bins alone is smooth, so few draws of rays are no improvement on it but where it is wrong.
constexpr std::uint32_t first_draws_of_smooth = 16, first_draws_of_sharp = 4;
// Shares are rounded, so that the mean is not exactly what was asked for.
constexpr double settled_draws = 0.9 * Gatherer::full_draws, last_draws = 0.9 * Gatherer::most_draws;
constexpr int shares_of_leisure = 12;  // one for the eye, the others for the photons

bool has_gloss_or_glass(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
        return material.base == Base::transparent || material.interface.present();
    });
}

}  // namespace

struct Gatherer::Eye {
    explicit Eye(std::shared_ptr<const Scene> seen)
        : scene(std::move(seen)), gather(std::make_shared<EyeScene>(*scene)) {}

    std::shared_ptr<const Scene> scene;
    Gather gather;
};

Gatherer::Gatherer() {
    worker_ = std::jthread([this](const std::stop_token& quit) { work(quit); });
}

Gatherer::~Gatherer() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    worker_.request_stop();
    work_to_do_.notify_all();
    worker_.join();
}

void Gatherer::want(const std::shared_ptr<const Scene>& scene, const std::shared_ptr<const Snapshot>& bins,
                    const Camera& camera, int width, int height, bool photons_fly) {
    const bool same = presented_ && presented_->scene == scene && same_pose(presented_->camera, camera) &&
                      presented_->width == width && presented_->height == height &&
                      presented_->bins->photons <= bins->photons;
    if (!same) ++wishes_;
    presented_ = Wish{scene, bins, camera, width, height, wishes_};
    const std::lock_guard lock(mutex_);
    newest_ = bins;
    newest_photons_ = bins->photons;
    photons_fly_ = photons_fly;
    if (!same) {
        wish_ = presented_;
        stop_ = true;
    }
    work_to_do_.notify_all();
}

void Gatherer::stop() {
    if (!presented_) return;
    presented_.reset();
    has_more_ = false;
    const std::lock_guard lock(mutex_);
    wish_.reset();
    stop_ = true;
    work_to_do_.notify_all();
}

std::vector<GatheredTile> Gatherer::take(std::size_t most) {
    std::vector<GatheredTile> taken;
    const std::unique_lock lock(tiles_mutex_, std::try_to_lock);
    if (!lock || !presented_ || tiles_wish_ != presented_->number) return taken;
    while (!tiles_.empty() && taken.size() < most) taken.push_back(std::move(tiles_.extract(tiles_.begin()).mapped()));
    has_more_ = !tiles_.empty();
    return taken;
}

// Threads that draw come here. `first`: over the bins, where a person sees the picture change.
void Gatherer::offer(const Wish& wish, int tile, std::uint64_t photons, bool first) {
    constexpr Clock::duration between_wakes = std::chrono::milliseconds(250);
    GatheredTile offered{eye_->gather.tile(tile), photons};
    bool wake = false;
    {
        const std::lock_guard lock(tiles_mutex_);
        if (tiles_wish_ != wish.number) tiles_.clear();
        tiles_wish_ = wish.number;
        tiles_.insert_or_assign(tile, std::move(offered));
        wake = first && Clock::now() - last_wake_ >= between_wakes;
        if (wake) last_wake_ = Clock::now();
    }
    // Not before: the window's thread would wait for this one, which it has just pushed aside, to let go.
    if (wake) Window::wake();
}

void Gatherer::work(const std::stop_token& quit) {
    lower_priority(Priority::lowest);
    while (!quit.stop_requested()) {
        Wish wish;
        {
            std::unique_lock lock(mutex_);
            if (!work_to_do_.wait(lock, quit, [this] { return wish_.has_value(); })) return;
            wish = *std::exchange(wish_, std::nullopt);
            stop_ = quit.stop_requested();
        }
        gather(wish);
    }
}

// Also where a thread that draws at its leisure rests, so many times as long as it has worked. Without photons there is
// no leisure.
bool Gatherer::asked_to_stop() {
    thread_local Clock::time_point last = Clock::now();
    if (at_leisure_) {
        // A thread's first call finds the end of another picture, so that work is counted to a second at most.
        constexpr Clock::duration nap = std::chrono::milliseconds(5), most_work = std::chrono::seconds(1);
        const Clock::time_point now = Clock::now();
        const Clock::time_point until = now + (shares_of_leisure - 1) * std::min(now - last, most_work);
        while (!stop_ && photons_fly_ && Clock::now() < until) std::this_thread::sleep_for(nap);
    }
    last = Clock::now();
    return stop_ || (at_leisure_ && !photons_fly_);
}

void Gatherer::gather(const Wish& wish) {
    if (!eye_ || eye_->scene != wish.scene) eye_ = std::make_unique<Eye>(wish.scene);
    Gather& gather = eye_->gather;
    gather.show(wish.bins);
    gather.look(wish.camera, wish.width, wish.height);
    const unsigned threads = thread_count();
    const double least = has_gloss_or_glass(*wish.scene) ? first_draws_of_sharp : first_draws_of_smooth;
    std::shared_ptr<const Snapshot> bins = wish.bins;
    std::uint64_t photons = bins->photons;
    double shown = 0;
    while (true) {
        const double before = gather.draws();
        if (before == 0) photons = bins->photons;
        const auto enough = [&] { return before >= (photons_fly_ ? last_draws : settled_draws); };
        bool better = false;
        if (shown == 0 && before >= least) {  // from an earlier wish
            for (int tile = 0; tile < gather.tiles() && !stop_; ++tile) offer(wish, tile, photons, true);
            better = true;
        } else if (!enough()) {
            at_leisure_ = photons_fly_ && std::max(shown, before) >= settled_draws;
            // Tiles have to become as complete as what is shown: at once, or, where there is time, with the newest bins.
            const auto complete =
                static_cast<std::uint32_t>(std::ceil(std::max(least, std::min(shown, settled_draws))));
            const auto draws =
                std::max(at_leisure_ ? 1u : complete, 2 * static_cast<std::uint32_t>(std::lround(before)));
            const bool as_good = draws >= complete;
            const auto offer_tile = [&](int tile) { offer(wish, tile, photons, shown == 0); };
            const bool first = before == 0 && !at_leisure_;
            const auto stop = [&] { return asked_to_stop() || (first && newest_photons_ >= far_better * photons); };
            const bool drawn = gather.draw(draws, threads, stop, as_good ? TileDrawn(offer_tile) : TileDrawn());
            better = drawn && as_good;
        }
        if (better) shown = gather.draws();
        std::shared_ptr<const Snapshot> newer;
        {
            std::unique_lock lock(mutex_);
            if (!better) work_to_do_.wait(lock, [&] { return stop_ || !enough() || newest_->photons / 2 > photons; });
            if (stop_) return;
            newer = newest_;
        }
        if (better) Window::wake();
        // A picture that is well begun is finished: where photons double sooner than it does, none ever would be.
        const bool begun = gather.draws() >= (at_leisure_ ? 1 : Gather::pilot_draws + 1);
        if (begun && gather.draws() < settled_draws && newer->photons / 2 > photons) continue;
        bins = std::move(newer);
        gather.show(bins);
    }
}

}  // namespace brewster
