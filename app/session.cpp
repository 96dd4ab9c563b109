#include "app/session.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "app/clock.h"
#include "app/memory.h"

namespace brewster {
namespace {

constexpr double good_error = 0.15;      // of a picture that takes the old one's place
constexpr double longest_stale = 0.06;   // seconds; then whatever there is does, and is on the screen at about 0.1
constexpr double at_once = 0.15;         // seconds
constexpr std::size_t most_steps = 100;  // that undo remembers

}  // namespace

Session::Session(std::shared_ptr<const Scene> scene, const EngineSettings& settings, const StopRule& rule)
    : now_{std::move(scene), settings.changes}, settings_(settings), rule_(rule) {
    begin_generation();
}

Session::~Session() = default;

// Whatever was traced before is nobody's wish.
void Session::begin_generation(std::unique_ptr<Engine> engine) {
    ++generation_;
    retire(std::exchange(engine_, nullptr));
    ready_ = offered_ = false;
    begun_at_ = answered_at_ = seconds_now();
    trouble_.clear();
    discard_ = making_.valid();
    if (!engine) {
        if (!discard_) make();
        return;
    }
    engine_ = std::move(engine);
    traced_generation_ = generation_;
    traced_scene_ = now_.scene;
}

void Session::begin_change() {
    if (!stale()) answered_at_ = seconds_now();
    ++generation_;
    if (free_for_change()) make();
}

// What is on its way shows light first: otherwise there would be none as long as changes keep coming.
bool Session::free_for_change() const {
    return !making_.valid() && (!engine_ || paused_ || offered_);
}

void Session::make() {
    // What the old engine would trace from now on is nobody's wish; let the new one have the processor.
    retire(std::exchange(engine_, nullptr));
    ready_ = offered_ = false;
    begun_at_ = seconds_now();
    trouble_.clear();
    traced_generation_ = generation_;
    traced_scene_ = now_.scene;
    settings_.changes = now_.changes;
    making_ = std::async(std::launch::async, [scene = now_.scene, settings = settings_, rule = rule_, rest = paused_] {
        Made made;
        try {
            made.engine = std::make_unique<Engine>(scene, settings);
            if (!rest) {
                made.engine->start(rule);
                made.rule = rule;
            }
        } catch (const std::exception& error) {
            made.trouble = error.what();
        }
        return made;
    });
}

void Session::take_made() {
    Made made = making_.get();
    if (std::exchange(discard_, false)) return retire(std::move(made.engine));
    engine_ = std::move(made.engine);
    trouble_ = std::move(made.trouble);
    if (!engine_)
        ready_ = true;  // no light: nothing will come
    else if (paused_)
        engine_->pause();
    else if (made.rule != rule_)
        go_on();
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
        give_back_free_pages();
    }));
}

void Session::advance() {
    offered_ = ready_;
    if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) take_made();
    if (traced_generation_ != generation_ && free_for_change()) make();
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
        ready_ = true;  // nothing more will come
    }
    if (ready_) return;
    const std::shared_ptr<const Snapshot> bins = engine_->snapshot();
    if (!bins) return;
    if (bins->relative_error > good_error && seconds_now() - begun_at_ < longest_stale) return;
    ready_ = true;
    answered_at_ = seconds_now();
}

std::optional<Session::Traced> Session::traced() const {
    if (!ready_) return {};
    return Traced{traced_scene_, traced_generation_, engine_ ? engine_->snapshot() : nullptr};
}

std::shared_ptr<const Snapshot> Session::snapshot() const {
    return engine_ && !stale() ? engine_->snapshot() : nullptr;
}

bool Session::overdue() const {
    return stale() && seconds_now() - answered_at_ > at_once;
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
    begin_change();
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
    begin_change();
}

void Session::open(std::shared_ptr<const Scene> scene, std::vector<std::string> changes,
                   std::unique_ptr<Engine> engine) {
    done_.clear();
    undone_.clear();
    now_ = {std::move(scene), std::move(changes)};
    paused_ = engine != nullptr;  // what was kept is looked at before more is traced
    begin_generation(std::move(engine));
}

void Session::restart() {
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
    saving_ = std::async(std::launch::async, [engine = engine_.get(), path] {
                  engine->pause();
                  engine->save(path);
              }).share();
}

std::optional<std::string> Session::take_saved() {
    return std::exchange(saved_, std::nullopt);
}

}  // namespace brewster
