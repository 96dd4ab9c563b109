#include "app/gatherer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/window.h"
#include "base/priority.h"
#include "base/threads.h"
#include "gather/gather.h"

namespace brewster {
namespace {

using Clock = std::chrono::steady_clock;

// A picture of bins alone is smooth, so few draws of rays are no improvement on it but where it is wrong.
constexpr std::uint32_t first_draws_of_smooth = 16, first_draws_of_sharp = 4;
constexpr int shares_of_leisure = 8;  // one for the eye, seven for the photons

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
                    const Camera& camera, int width, int height) {
    const bool same = presented_ && presented_->scene == scene && same_pose(presented_->camera, camera) &&
                      presented_->width == width && presented_->height == height &&
                      presented_->bins->photons <= bins->photons;
    presented_ = Wish{scene, bins, camera, width, height};
    const std::lock_guard lock(mutex_);
    newest_ = bins;
    if (!same) {
        wish_ = presented_;
        ready_ = {};
        stop_ = true;
    }
    work_to_do_.notify_all();
}

void Gatherer::stop() {
    if (!presented_) return;
    presented_.reset();
    const std::lock_guard lock(mutex_);
    wish_.reset();
    ready_ = {};
    stop_ = true;
    work_to_do_.notify_all();
}

std::optional<GatheredPicture> Gatherer::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(ready_, {});
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

// Also where a thread that draws at its leisure rests, seven times as long as it has worked.
bool Gatherer::asked_to_stop() {
    thread_local Clock::time_point last = Clock::now();
    if (at_leisure_) {
        // A thread's first call finds the end of another picture, so that work is counted to a second at most.
        constexpr Clock::duration nap = std::chrono::milliseconds(5), most_work = std::chrono::seconds(1);
        const Clock::time_point now = Clock::now();
        const Clock::time_point until = now + (shares_of_leisure - 1) * std::min(now - last, most_work);
        while (!stop_ && Clock::now() < until) std::this_thread::sleep_for(nap);
    }
    last = Clock::now();
    return stop_.load(std::memory_order_relaxed);
}

void Gatherer::gather(const Wish& wish) {
    if (!eye_ || eye_->scene != wish.scene) eye_ = std::make_unique<Eye>(wish.scene);
    Gather& gather = eye_->gather;
    gather.show(wish.bins);
    gather.look(wish.camera, wish.width, wish.height);
    const unsigned threads = thread_count();
    // A picture of newer bins has to become as complete as the one that is shown.
    const double least = has_gloss_or_glass(*wish.scene) ? first_draws_of_sharp : first_draws_of_smooth;
    std::shared_ptr<const Snapshot> bins = wish.bins;
    std::uint64_t photons = bins->photons;
    double shown = 0;
    while (true) {
        const double before = gather.draws();
        if (before == 0) photons = bins->photons;
        if (before < most_draws) {
            const std::uint32_t draws = std::max(1u, 2 * static_cast<std::uint32_t>(std::lround(before)));
            at_leisure_ = draws > full_draws;
            if (!gather.draw(draws, threads, [this] { return asked_to_stop(); })) return;
            if (gather.draws() >= std::max(least, 0.9 * std::min<double>(shown, full_draws))) {
                shown = gather.draws();
                auto light = std::make_shared<const StokesPicture>(gather.picture());
                const std::lock_guard lock(mutex_);
                if (stop_) return;
                ready_ = GatheredPicture{std::move(light), photons};
                Window::wake();
            }
        }
        std::unique_lock lock(mutex_);
        if (gather.draws() >= most_draws)  // nothing to do before the photons have doubled
            work_to_do_.wait(lock, [&] { return stop_ || newest_->photons / 2 > photons; });
        if (stop_) return;
        bins = newest_;
        lock.unlock();
        gather.show(bins);
    }
}

}  // namespace brewster
