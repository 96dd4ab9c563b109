#include "app/session.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "app/clock.h"

namespace brewster {
namespace {

constexpr double good_error = 0.15;      // of a picture that takes the old one's place
constexpr double longest_stale = 0.1;    // seconds; then whatever there is does
constexpr std::size_t most_steps = 100;  // that undo remembers

}  // namespace

Session::Session(std::shared_ptr<const Scene> scene, const EngineSettings& settings, const StopRule& rule)
    : scene_(std::move(scene)), settings_(settings), rule_(rule) {
    begin_generation();
}

Session::~Session() = default;

void Session::begin_generation() {
    // What it would trace from now on is nobody's wish; let the new engine have the processor.
    if (engine_) retire(std::exchange(engine_, nullptr));
    ready_ = false;
    changed_at_ = seconds_now();
    replaced_after_ms_.reset();
    wanted_ = true;
    if (!making_.valid()) make();
}

void Session::make() {
    wanted_ = false;
    making_generation_ = generation_;
    making_ = std::async(std::launch::async, [scene = scene_, settings = settings_] {
        Made made;
        try {
            made.engine = std::make_unique<Engine>(scene, settings);
        } catch (const std::exception& error) {
            made.trouble = error.what();
        }
        return made;
    });
}

void Session::retire(std::unique_ptr<Engine> engine) {
    std::erase_if(retiring_, [](std::future<void>& done) {
        return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    // Its threads end with their blocks; the window does not wait for them.
    retiring_.push_back(std::async(std::launch::async, [old = std::move(engine)]() mutable { old.reset(); }));
}

void Session::advance() {
    if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        Made made = making_.get();
        if (wanted_) {
            if (made.engine) retire(std::move(made.engine));
            make();
        } else {
            engine_ = std::move(made.engine);
            trouble_ = std::move(made.trouble);
            if (engine_ && !paused_) engine_->start(rule_);
            if (!engine_) ready_ = true;  // no light: nothing will come
        }
    }
    if (!engine_) return;
    try {
        engine_->wait_for(0);
    } catch (const std::exception& error) {
        trouble_ = error.what();
    }
    if (ready_) return;
    const std::shared_ptr<const Snapshot> bins = engine_->snapshot();
    if (!bins) return;
    const double waited = seconds_now() - changed_at_;
    if (bins->relative_error > good_error && waited < longest_stale) return;
    ready_ = true;
    replaced_after_ms_ = 1000 * waited;
}

std::shared_ptr<const Snapshot> Session::snapshot() const {
    return ready_ && engine_ ? engine_->snapshot() : nullptr;
}

void Session::change(std::shared_ptr<const Scene> changed, bool new_step) {
    if (new_step) {
        done_.push_back(scene_);
        if (done_.size() > most_steps) done_.erase(done_.begin());
    }
    undone_.clear();
    scene_ = std::move(changed);
    ++generation_;
    begin_generation();
}

void Session::undo() {
    if (done_.empty()) return;
    undone_.push_back(std::exchange(scene_, done_.back()));
    done_.pop_back();
    ++generation_;
    begin_generation();
}

void Session::redo() {
    if (undone_.empty()) return;
    done_.push_back(std::exchange(scene_, undone_.back()));
    undone_.pop_back();
    ++generation_;
    begin_generation();
}

void Session::open(std::shared_ptr<const Scene> scene) {
    done_.clear();
    undone_.clear();
    scene_ = std::move(scene);
    paused_ = false;
    ++generation_;
    begin_generation();
}

void Session::restart() {
    ++generation_;
    begin_generation();
}

void Session::pause() {
    paused_ = true;
    if (engine_) engine_->pause();
}

void Session::resume() {
    paused_ = false;
    if (!engine_) return;
    if (engine_->progress().photons > 0)
        engine_->resume();
    else
        engine_->start(rule_);
}

void Session::set_target_error(std::optional<double> error) {
    rule_.target_error = error;
    if (!engine_) return;
    engine_->pause();
    if (!paused_) engine_->start(rule_);
}

}  // namespace brewster
