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
    : now_{std::move(scene), settings.changes}, settings_(settings), rule_(rule) {
    begin_generation();
}

Session::~Session() = default;

void Session::begin_generation(std::unique_ptr<Engine> engine) {
    // What the old one would trace from now on is nobody's wish; let the new one have the processor.
    retire(std::exchange(engine_, nullptr));
    ready_ = false;
    changed_at_ = seconds_now();
    replaced_after_ms_.reset();
    trouble_.clear();
    wanted_ = !engine;
    if (engine) {
        if (making_.valid()) retire(making_.get().engine);
        engine_ = std::move(engine);
        return;
    }
    if (!making_.valid()) make();
}

void Session::make() {
    wanted_ = false;
    settings_.changes = now_.changes;
    making_ = std::async(std::launch::async, [scene = now_.scene, settings = settings_] {
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
    if (!engine) return;
    retiring_.push_back(std::async(std::launch::async, [old = std::move(engine), saving = saving_]() mutable {
        if (saving.valid()) saving.wait();
        old.reset();
    }));
}

void Session::advance() {
    if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        Made made = making_.get();
        if (wanted_) {
            retire(std::move(made.engine));
            make();
        } else {
            engine_ = std::move(made.engine);
            trouble_ = std::move(made.trouble);
            if (engine_ && !paused_) engine_->start(rule_);
            if (!engine_) ready_ = true;  // no light: nothing will come
        }
    }
    if (saving_.valid() && saving_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        saved_ = "";
        try {
            saving_.get();
        } catch (const std::exception& error) {
            saved_ = error.what();
        }
        saving_ = {};
        if (!paused_) go_on();
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

void Session::change(std::shared_ptr<const Scene> changed, const Setting& setting, bool new_step) {
    if (new_step) {
        done_.push_back(now_);
        if (done_.size() > most_steps) done_.erase(done_.begin());
    }
    undone_.clear();
    now_.scene = std::move(changed);
    const std::string owner = setting_text({setting.owner, setting.property, ""});
    if (!now_.changes.empty() && now_.changes.back().starts_with(owner)) now_.changes.pop_back();
    now_.changes.push_back(setting_text(setting));
    ++generation_;
    begin_generation();
}

void Session::undo() {
    take_step(done_, undone_);
}

void Session::redo() {
    take_step(undone_, done_);
}

void Session::take_step(std::vector<Version>& from, std::vector<Version>& to) {
    if (from.empty()) return;
    to.push_back(std::exchange(now_, from.back()));
    from.pop_back();
    ++generation_;
    begin_generation();
}

void Session::open(std::shared_ptr<const Scene> scene, std::vector<std::string> changes,
                   std::unique_ptr<Engine> engine) {
    done_.clear();
    undone_.clear();
    now_ = {std::move(scene), std::move(changes)};
    paused_ = engine != nullptr;  // what was kept is looked at before more is traced
    ++generation_;
    begin_generation(std::move(engine));
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
    go_on();
}

void Session::go_on() {
    if (!engine_ || saving()) return;
    engine_->pause();
    engine_->start(rule_);
}

void Session::set_target_error(std::optional<double> error) {
    rule_.target_error = error;
    if (!paused_) go_on();
}

void Session::save(const std::string& path) {
    if (!engine_ || saving()) return;
    engine_->pause();
    saving_ = std::async(std::launch::async, [engine = engine_.get(), path] { engine->save(path); }).share();
}

std::optional<std::string> Session::take_saved() {
    return std::exchange(saved_, std::nullopt);
}

}  // namespace brewster
