#include "app/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "app/clock.h"
#include "app/newer_bins.h"
#include "app/numbers.h"
#include "app/picture_names.h"
#include "app/preferences.h"
#include "app/seen_point.h"
#include "app/trace.h"
#include "app/view_text.h"
#include "image/png.h"

namespace brewster {
namespace {

constexpr double rest_after = 0.15;                // seconds without motion
constexpr double seconds_between_presents = 0.25;  // at rest
constexpr double seconds_between_numbers = 1;      // where nothing but the panels' numbers goes on
constexpr double gather_after = 0.3;               // seconds without motion
constexpr double gather_bins_after = 2;            // seconds after their first photons
constexpr std::size_t tiles_in_a_frame =
    Picture::frame_bytes / (tile_pixels * tile_pixels * GatheredLight::pixel_bytes);
constexpr double seconds_between_file_looks = 1;
constexpr double seconds_between_snapshots = 0.5;
/// A frame that takes longer than this was drawn by the processor, which the photons need too: at rest three times as
/// long is left to them before the next.
constexpr double slow_frame = 0.02;                         // seconds
constexpr double slow_present = 0.005, longest_nap = 0.02;  // seconds
constexpr int bands_of_slow_draw = 24;
constexpr std::uint64_t photons_of_settled_exposure = 1000000;
constexpr float wheel_radius = 58;  // pixels at scale 1

EngineSettings beside_a_window(EngineSettings settings) {
    settings.lowest_priority = true;
    settings.snapshot_seconds = seconds_between_snapshots;
    return settings;
}

EngineSettings with_changes(EngineSettings settings, const std::vector<Setting>& changes) {
    for (const Setting& change : changes) settings.changes.push_back(setting_text(change));
    return settings;
}

/// A scene, or a saved solution of the present one.
Solution read_file(const std::string& path, const std::string& present_scene, const OpenOptions& options) {
    if (!is_solution(path)) return {load_scene(path, options.settings), nullptr};
    SolveOptions solve;
    solve.scene = present_scene;
    solve.resume = path;
    solve.engine = beside_a_window(options.engine);
    return saved_solution(solve);
}

}  // namespace

Viewer::Viewer(Window& window, std::shared_ptr<const Scene> scene, const OpenOptions& options, double started)
    : window_(window),
      settings_(options.settings),
      overlay_(window),
      file_(options.scene, [options](const std::string& path,
                                     const std::string& present) { return read_file(path, present, options); }),
      session_(scene, with_changes(beside_a_window(options.engine), options.settings), options.stop),
      scene_(scene),
      surfaces_(scene),
      rays_(std::make_unique<Rays>(*scene)),
      canvas_(scene),
      navigation_([this](const Camera& camera, glm::vec2 place) { return seen(camera, place); }, scene->radius()),
      preferences_(read_preferences(config_folder(), shown_.complaint)),
      written_preferences_(preferences_),
      started_(started) {
    glimpse_.open(scene);
    view_.camera = scene->cameras.front();
    home_camera_ = view_.camera.name;
    if (const auto palette = find_palette(preferences_.palette)) view_.rendition.palette = *palette;
    shown_generation_ = session_.generation();
    last_step_ = seconds_now();
    if (!options.replay.empty()) {
        replay_ = std::make_unique<Replay>(options.replay, options.report);
        stage_ = make_stage();
        preferences_ = written_preferences_ = {};
        preferences_.first_run = false;
        written_preferences_ = preferences_;
    }
    if (!options.scene.empty()) remember_file(options.scene);
    if (!options.record.empty()) record_.open(options.record);
}

Viewer::~Viewer() {
    if (record_.is_open()) record_ << "]}\n";
    if (!replay_ && preferences_ != written_preferences_) write_preferences(config_folder(), preferences_);
}

bool Viewer::run() {
    double turn_begin = seconds_now();
    while (!quit_ && !window_.close_requested()) {
        if (replay_) replay_->turned(1000 * (seconds_now() - turn_begin));
        wait();
        turn_begin = seconds_now();
        if (replay_ && !replay_->advance(stage_)) break;
        overlay_.set_style(preferences_.text_scale, preferences_.light);
        const Sight before = view_;
        take_file();
        session_.advance();
        for (const InputEvent& event : window_.take_events()) {
            if (record_.is_open()) record(event);
            handle(event);
        }
        for (const std::string& path : window_.take_drops()) file_.open(path);
        take_saved_solution();
        fly(seconds_now() - last_step_);
        last_step_ = seconds_now();
        if (window_.take_damage()) must_present_ = true;
        const glm::ivec2 size = window_.framebuffer_size();
        hidden_ = size.x < 1 || size.y < 1 || window_.hidden();
        if (hidden_) continue;
        make_widgets();
        if (!same_pose(before.camera, view_.camera)) {
            last_motion_ = seconds_now();
            gatherer_.stop();
            canvas_.show_bins();
        }
        if (!(before == view_)) must_present_ = true;
        take_bins();
        gather_at_rest();
        draw();
        advance_taken_picture();
    }
    return !replay_ || !replay_->failed();
}

void Viewer::wait() {
    const double wanted = patience();
    const double allowed = replay_ ? std::min(wanted, replay_->patience()) : wanted;
    if (allowed > 0)
        window_.wait_events(allowed);
    else
        window_.poll_events();
}

// Seconds until something is to be done, if no event comes before.
double Viewer::patience() const {
    if (hidden_) return seconds_between_presents;
    if (must_present_ || widget_frames_ > 0 || moving() || navigation_.flying() || !canvas_.picture().uploaded() ||
        gatherer_.has_more() || making_room_)
        return 0;
    if (drawing_wanted()) return pause_;
    if (taken_) return taken_->of_rays() ? 0.05 : 0;
    if (session_.stale() || session_.saving() || file_.reading()) return 0.005;
    const bool tracing = session_.engine() && session_.engine()->progress().running;
    if (canvas_.gathered() && improved_) return std::max(0.0, last_present_ + seconds_between() - seconds_now());
    return tracing ? seconds_between() : seconds_between_file_looks;
}

// Presents at rest: what is settled gets better too slowly for more.
double Viewer::seconds_between() const {
    return canvas_.settled() ? seconds_between_numbers : seconds_between_presents;
}

bool Viewer::moving() const {
    return seconds_now() - last_motion_ < rest_after;
}

// New light has just come, and more of it is about to.
bool Viewer::fresh() const {
    return seconds_now() - bins_since_ < rest_after;
}

int Viewer::shrinking() const {
    if (moving() || fresh()) return resolution_.half() ? 2 : 1;
    return session_.stale() ? shrinking_ : 1;  // another would be drawn anew
}

bool Viewer::drawing_wanted() const {
    const Picture& picture = canvas_.picture();
    // Light that is about to be replaced is not worth improving.
    const int wanted = !picture.bins() || session_.stale() ? 1
                       : view_.of_rays()                   ? draws_before_change
                                                           : Picture::full_draws;
    return picture.draws(Canvas::needed(view_, comparing_)) < wanted;
}

glm::ivec2 Viewer::picture_size() const {
    const glm::ivec2 size = window_.framebuffer_size();
    const int column = column_width(preferences_.panels, overlay_.text_scale(), size.x);
    return {std::max(1, size.x - column), std::max(1, size.y)};
}

std::optional<glm::vec3> Viewer::seen(const Camera& camera, glm::vec2 place) const {
    const glm::ivec2 size = picture_size();
    return seen_point(*rays_, camera.position, ray_direction(camera, size.x, size.y, place.x, place.y));
}

void Viewer::remember_file(const std::string& path) {
    const std::filesystem::path absolute = std::filesystem::absolute(path);
    std::erase(preferences_.recent_files, absolute.string());
    preferences_.recent_files.insert(preferences_.recent_files.begin(), absolute.string());
    preferences_.folder = absolute.parent_path().string();
}

void Viewer::take_file() {
    const double now = seconds_now();
    if (now - last_look_at_file_ > seconds_between_file_looks) {
        last_look_at_file_ = now;
        file_.look_for_changes();
    }
    std::optional<SceneFile::Outcome> outcome = file_.take();
    if (!outcome) return;
    must_present_ = true;
    if (!outcome->scene) {
        shown_.complaint = outcome->complaint;
        return;
    }
    const bool saved = outcome->engine != nullptr;
    std::vector<std::string> changes =
        saved ? outcome->engine->settings().changes : with_changes({}, settings_).changes;
    session_.open(outcome->scene, std::move(changes), std::move(outcome->engine));
    set_scene(outcome->scene, session_.generation(), false);
    shown_.files = false;
    if (saved) return notice(outcome->path + " was taken up where it was saved; Space traces on");
    remember_file(outcome->path);
    window_.set_title("Brewster: " + scene_->name);
    if (outcome->again) return notice("the file has changed and was read again");
    go_to(scene_->cameras.front());
    home_camera_ = view_.camera.name;
    shown_.material = shown_.lamp = -1;
    kept_views_ = {};
    exposure_settled_ = exposure_by_hand_ = false;
}

void Viewer::set_scene(std::shared_ptr<const Scene> scene, std::uint64_t generation, bool same_surfaces) {
    gatherer_.stop();
    if (same_surfaces) {
        canvas_.repaint(scene);
        // A change is seen against the light before it.
        if (canvas_.picture().bins()) exposure_settled_ = true;
    } else {
        canvas_.open(scene);
        rays_ = std::make_unique<Rays>(*scene);
        surfaces_ = scene;
        navigation_ =
            Navigation([this](const Camera& camera, glm::vec2 place) { return seen(camera, place); }, scene->radius());
        region_.reset();
        light_.reset();
        surface_.reset();  // a chart of the old scene
    }
    scene_ = std::move(scene);
    glimpse_.open(scene_);
    shown_generation_ = generation;
    must_present_ = true;
}

// The old picture stays until there is new light, or for so long that a person waits: then what is known of the new
// scene without light is shown.
void Viewer::follow_session() {
    const auto follow = [&](const std::shared_ptr<const Scene>& scene, std::uint64_t generation) {
        if (shown_generation_ != generation) set_scene(scene, generation, true);
    };
    if (const std::optional<Session::Traced> traced = session_.traced())
        follow(traced->scene, traced->generation);
    else if (session_.overdue())
        follow(session_.scene(), session_.generation());
}

void Viewer::take_bins() {
    follow_session();
    const std::optional<Session::Traced> traced = session_.traced();
    Picture& picture = canvas_.picture();
    const Rendition wanted = Canvas::needed(view_, comparing_);
    const bool replaced = traced && traced->bins && traced->generation != sent_generation_;
    // What rays show does not wait for bins; they are taken up again with the first motion.
    const bool idle = canvas_.settled() && !replaced && !moving();
    if (traced && traced->bins) {
        const Newer newer = picture.bins()
                                ? newer_bins(picture.bins()->photons, traced->bins->photons, picture.draws(wanted))
                                : Newer::at_once;
        if (replaced || moving() || (!idle && newer != Newer::wait)) {
            picture.show(traced->bins);
            presents_at_once_ = newer == Newer::at_once;
            sent_generation_ = traced->generation;
        }
    }
    if (picture.uploaded() || !picture.upload(Picture::frame_bytes)) return;
    draws_to_present_ = moving() || presents_at_once_ ? 1 : draws_before_change;
    if (bins_generation_ != sent_generation_) {
        bins_generation_ = sent_generation_;
        bins_since_ = seconds_now();
        draws_to_present_ = 1;
        must_present_ = true;
    }
    improved_ = true;
    if (exposure_settled_) return;
    view_.rendition.exposure = picture.exposure_of(scene_->cameras.front());
    exposure_settled_ = picture.bins()->photons >= photons_of_settled_exposure;
}

Desk Viewer::desk() {
    Desk desk{.scene = *session_.scene(),
              .session = session_,
              .progress = {},
              .frame_ms = 1000 * frame_seconds_,
              .samples = static_cast<double>(canvas_.picture().draws(Canvas::needed(view_, comparing_))),
              .gathered = 0,
              .photons_shown = canvas_.photons_shown(),
              .taking = taken_ ? std::optional(taken_->share()) : std::nullopt,
              .light = light_,
              .surface = surface_,
              .region = region_.has_value(),
              .scale = overlay_.text_scale(),
              .view = view_,
              .preferences = preferences_,
              .shown = shown_,
              .act = [this](Action action, int argument) { act(action, argument); },
              .change_scene = [this](std::shared_ptr<const Scene> scene, const Setting& setting,
                                     bool new_step) { session_.change(std::move(scene), setting, new_step); },
              .open_file = [this](const std::string& path) { file_.open(path); },
              .save = [this](const std::string& kind) { take_picture(new_path(kind), true); },
              .save_solution = [this] { save_solution(new_path(".bins")); },
              .set_target_error = [this](std::optional<double> error) { session_.set_target_error(error); },
              .copy = [this](const std::string& text) { window_.set_clipboard(text); }};
    if (session_.engine()) desk.progress = session_.engine()->progress();
    if (const SettlingPicture* gathered = canvas_.gathered()) {
        desk.gathered = gathered->share();
        desk.samples = gathered->samples();
    }
    return desk;
}

void Viewer::make_widgets() {
    const glm::ivec2 size = window_.framebuffer_size();
    const glm::vec2 picture(picture_size());
    const float exposure = view_.rendition.exposure;
    overlay_.begin();
    Desk made = desk();
    panel_column(made, size);
    const float radius = std::min(wheel_radius * made.scale, 0.2f * std::min(picture.x, picture.y));
    analyzer_wheel(made, {picture.x - 1.4f * radius, picture.y - 1.4f * radius}, radius);
    split_slider(made, picture);
    first_run_card(made);
    help_window(made);
    files_window(made);
    complaint_window(made);
    if (region_) {
        ImGui::GetBackgroundDrawList()->AddRect({(*region_)[0].x, (*region_)[0].y}, {(*region_)[1].x, (*region_)[1].y},
                                                IM_COL32(240, 150, 50, 255), 0, 0, std::max(1.0f, made.scale));
    }
    overlay_.end();
    if (view_.rendition.exposure != exposure) exposure_settled_ = exposure_by_hand_ = true;
    if (overlay_.is_being_used()) widget_frames_ = std::max(widget_frames_, 2);
    if (view_.rendition.analyzer.kind == Analyzer::Kind::linear) view_.rendition.analyzer.angle = view_.analyzer_angle;
    if (widget_frames_ > 0) {
        --widget_frames_;
        must_present_ = true;
    }
}

void Viewer::look_around_pointer() {
    light_.reset();
    surface_.reset();
    if (!preferences_.panels || !shown_.inspector) return;
    const glm::ivec2 size = picture_size();
    const bool polarization = view_.rendition.polarization != comparing_;
    if (region_) {
        const glm::vec2 low = glm::min((*region_)[0], (*region_)[1]), high = glm::max((*region_)[0], (*region_)[1]);
        light_ = canvas_.look_at(glm::ivec2(low), glm::ivec2(high) + 1, size, polarization);
        return;
    }
    const auto in_picture = [&](glm::vec2 at) {
        return at.x >= 0 && at.y >= 0 && at.x < static_cast<float>(size.x) && at.y < static_cast<float>(size.y);
    };
    // The last point stays while the pointer is over the panels, which is where its numbers are read.
    if (in_picture(window_.pointer())) inspected_ = window_.pointer();
    if (!inspected_ || !in_picture(*inspected_)) return;
    const glm::vec2 place = *inspected_;
    light_ = canvas_.look_at(glm::ivec2(place), glm::ivec2(place) + 1, size, polarization);
    surface_ = seen_surface(*scene_, *rays_, view_.camera.position,
                            ray_direction(view_.camera, size.x, size.y, place.x, place.y));
}

void Viewer::gather_at_rest() {
    const glm::ivec2 size = picture_size();
    making_room_ = false;
    const SettlingPicture* gathered = canvas_.gathered();
    const bool fits = gathered && gathered->size() == size;
    if (gathered && (!view_.of_rays() || !fits)) {
        must_present_ = true;
        canvas_.show_bins();
    }
    const bool still = seconds_now() - last_motion_ >= gather_after && !navigation_.dragging();
    // At first photons double faster than rays could follow.
    const bool photons_fly = session_.engine() && session_.engine()->progress().running;
    const bool ripe = seconds_now() - bins_since_ >= gather_bins_after || !photons_fly;
    const auto bins = session_.snapshot();
    if (!view_.of_rays() || !still || !ripe || taken_ || !bins || bins_generation_ != session_.generation())
        return gatherer_.stop();
    gatherer_.want(scene_, bins, view_.camera, size.x, size.y, photons_fly);
    making_room_ = !canvas_.make_room(size);
    if (making_room_) return;
    const std::vector<GatheredTile> tiles = gatherer_.take(tiles_in_a_frame);
    if (tiles.empty()) return;
    const bool whole = canvas_.settled();
    canvas_.show_gathered(tiles, size);
    if (canvas_.settled() && !whole) must_present_ = true;
    improved_ = true;
    draws_to_present_ = 1;
}

void Viewer::draw() {
    const double begin = frame_begin_ = seconds_now();
    const bool in_motion = moving();
    const glm::ivec2 size = picture_size();
    shrinking_ = shrinking();
    Picture& picture = canvas_.picture();
    picture.look(view_.camera, (size.x + shrinking_ - 1) / shrinking_, (size.y + shrinking_ - 1) / shrinking_);
    if (!view_.of_rays() || !picture.bins())
        glimpse_.clear(picture);
    else if (!canvas_.settled())
        glimpse_.show(picture, view_.camera, bins_generation_);
    const bool drawn = drawing_wanted();
    const Rendition needed = Canvas::needed(view_, comparing_);
    // At rest nobody waits for a whole draw, but somebody may come.
    const bool whole = in_motion || fresh() || !resolution_.half();
    const bool running = session_.engine() && session_.engine()->progress().running;
    const bool due = begin - last_present_ >= seconds_between();
    // What was there stays until the first draw has all of its bands.
    const auto is_whole = [&] { return canvas_.settled() || picture.draws(needed) > 0; };
    const auto wants_present = [&] {
        if (drawn && !is_whole()) return false;
        const bool better = improved_ && (canvas_.gathered() || picture.draws(needed) >= draws_to_present_);
        return must_present_ || in_motion || (due && (better || running));
    };
    // A band and a present would keep input waiting for both; presents that follow each other leave every other turn to
    // a band.
    const bool draws_now = drawn && (whole || band_is_overdue_ || !wants_present());
    band_is_overdue_ = drawn && !draws_now;
    if (draws_now) {
        const int before = picture.draws(needed);
        if (whole)
            picture.draw(1, needed);
        else
            picture.draw_band(bands_of_slow_draw, needed);
        if (picture.draws(needed) > before) improved_ = true;
    }
    if (wants_present()) {
        present();
    } else if (drawn) {
        picture.finish();
    }
    const double took = seconds_now() - begin;
    pause_ = !in_motion && drawn && is_whole() && (took > slow_frame || !whole) ? 3 * took : 0;
    if (drawn && whole && !keeps_resolution_) resolution_.frame_took(took);
    if (in_motion && drawn) frame_seconds_ = took;
    // Frames of sliders could follow each other without a pause; photons that are waited for need one.
    if (session_.stale() && !in_motion && took > slow_present)
        std::this_thread::sleep_for(std::chrono::duration<double>(std::min(took, longest_nap)));
}

Caption Viewer::caption() {
    Caption caption{scene_->name,
                    name_of(view_.camera),
                    "",
                    true,
                    session_.overdue() && canvas_.picture().bins(),
                    preferences_.text_scale,
                    window_.content_scale()};
    if (caption.dimmed)
        caption.status = session_.paused() ? "paused: Space traces the change" : "the change is being traced";
    else if (!session_.trouble().empty())
        caption.status = session_.trouble();
    else if (!shown_.notice.empty() && shown_.notice_until > seconds_now())
        caption.status = shown_.notice;
    else if (taken_)
        caption.status = said_of_taking_ = taking_words();
    else if (session_.saving())
        caption.status = "saving " + solution_path_;
    else if (session_.paused())
        caption.status = "paused";
    else if (!preferences_.panels && session_.engine())
        caption.status = with_magnitude(static_cast<double>(session_.engine()->progress().photons)) + " photons";
    return caption;
}

void Viewer::present() {
    must_present_ = improved_ = false;
    last_present_ = seconds_now();
    const glm::ivec2 whole = window_.framebuffer_size(), size = picture_size();
    Screen::window(whole.x, whole.y).bind();
    look_around_pointer();
    canvas_.present(Screen::window(size.x, size.y), view_, comparing_, caption());
    Screen::window(whole.x, whole.y).bind();
    overlay_.draw();
    if (wanted_capture_) write_png(*std::exchange(wanted_capture_, {}), Screen::window(whole.x, whole.y).read());
    window_.swap();
    if (replay_) replay_->presented(1000 * (seconds_now() - frame_begin_), stage_);
}

}  // namespace brewster
