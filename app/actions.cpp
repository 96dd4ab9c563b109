// What keys and the mouse do in the window.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/clock.h"
#include "app/seen_point.h"
#include "app/view_text.h"
#include "app/viewer.h"

namespace brewster {
namespace {

constexpr double double_press = 0.35;  // seconds
constexpr float near_by = 6;           // pixels
constexpr double notice_seconds = 3;
constexpr float flights_a_second = 0.5f;  // radii of the scene

}  // namespace

void Viewer::notice(const std::string& text) {
    shown_.notice = text;
    shown_.notice_until = seconds_now() + notice_seconds;
    must_present_ = true;
}

void Viewer::handle(const InputEvent& event) {
    using Kind = InputEvent::Kind;
    const bool over_widget = overlay_.wants_mouse();
    if (event.kind != Kind::motion || over_widget || (preferences_.panels && shown_.inspector) || region_)
        widget_frames_ = std::max(widget_frames_, event.kind == Kind::motion ? 1 : 3);
    if (event.kind == Kind::key_press) return press(event);
    if (event.kind == Kind::key_release) {
        if (event.key == "C" && comparing_) {
            comparing_ = false;
            must_present_ = true;
        }
        std::erase(held_fly_keys_, event.key.empty() ? '\0' : event.key[0]);
        return;
    }
    if (over_widget && event.kind != Kind::button_release && !navigation_.dragging() && !dragging_region_) return;
    const glm::ivec2 size = picture_size();
    const bool outside = event.place.x >= static_cast<float>(size.x);
    // Widgets feel the pointer a frame late: over the panels nothing is the picture's.
    if (outside && (event.kind == Kind::button_press || event.kind == Kind::wheel)) return;
    if (event.kind == Kind::button_press) overlay_.release_keyboard();
    if (dragging_region_ || (event.kind == Kind::button_press && event.control && event.button == Button::left))
        return drag_region(event);
    if (event.kind == Kind::wheel && event.alt) return turn_analyzer(static_cast<double>(event.notches));
    if (event.kind == Kind::button_press && event.button == Button::left && !event.shift) {
        const bool twice =
            seconds_now() - last_press_ < double_press && glm::length(event.place - last_press_place_) < near_by;
        last_press_ = twice ? -1e9 : seconds_now();
        last_press_place_ = event.place;
        if (twice) {
            navigation_.set_pivot(seen(view_.camera, event.place));
            notice("turning around this point from now on (Home: around the middle again)");
        }
    }
    view_.camera = navigation_.moved(view_.camera, event, size);
    if (!navigation_.flying()) held_fly_keys_.clear();
}

void Viewer::drag_region(const InputEvent& event) {
    switch (event.kind) {
        case InputEvent::Kind::button_press:
            dragging_region_ = true;
            shown_.inspector = true;
            region_ = {event.place, event.place};
            break;
        case InputEvent::Kind::motion:
            (*region_)[1] = event.place;
            break;
        case InputEvent::Kind::button_release:
            dragging_region_ = false;
            if (glm::length((*region_)[1] - (*region_)[0]) < 2) region_.reset();
            break;
        default:
            break;
    }
    must_present_ = true;
}

void Viewer::fly(double seconds) {
    if (!navigation_.flying() || held_fly_keys_.empty()) return;
    const auto held = [&](char key) { return held_fly_keys_.find(key) != std::string::npos ? 1.0f : 0.0f; };
    const glm::vec3 way(held('D') - held('A'), held('E') - held('Q'), held('W') - held('S'));
    const float metres = flights_a_second * scene_->radius() * static_cast<float>(std::min(seconds, 0.1));
    view_.camera = flown(view_.camera, way, metres);
}

void Viewer::press(const InputEvent& event) {
    if (overlay_.wants_text()) return;
    if (navigation_.flying() && event.key.size() == 1 && fly_keys.find(event.key) != std::string_view::npos) {
        if (held_fly_keys_.find(event.key) == std::string::npos) held_fly_keys_ += event.key;
        return;
    }
    // Widgets would take it, too, where a panel was clicked.
    if (event.key == "Tab") overlay_.release_keyboard();
    const KeyBinding* row = binding_of(chord_of(event));
    if (row && (!event.repeat || repeats(row->action))) act(row->action, row->argument);
}

void Viewer::go_to(const Camera& camera) {
    view_.camera = camera;
    navigation_.release();
}

std::string Viewer::words() const {
    View view;
    const glm::ivec2 size = picture_size();
    view.camera = view_.camera.name;
    const bool of_file = std::any_of(scene_->cameras.begin(), scene_->cameras.end(), [this](const Camera& camera) {
        return camera.name == view_.camera.name && same_pose(camera, view_.camera);
    });
    if (!of_file) view.pose = pose_of(*scene_, view_.camera);
    view.size = PictureSize{size.x, size.y};
    view.exposure = static_cast<double>(view_.rendition.exposure);
    view.map = view_.rendition.map;
    view.palette = view_.rendition.palette;
    view.analyzer = view_.rendition.analyzer;
    view.polarization = view_.rendition.polarization;
    view.gather = view_.gather;
    view.samples = TakenPicture::draws;
    if (session_.engine()) view.seed = session_.engine()->settings().seed;
    return view_text(view);
}

void Viewer::go_to_words(const std::string& text) {
    if (text.find('=') == std::string::npos) return notice("there is no view in the clipboard; Ctrl+C copies this one");
    try {
        const View view = parse_view(text);
        const float near_distance = view_.camera.near_distance;
        go_to(camera_of(*scene_, view));
        view_.camera.near_distance = near_distance;
        Rendition& rendition = view_.rendition;
        if (view.exposure) {
            rendition.exposure = static_cast<float>(*view.exposure);
            exposure_settled_ = exposure_by_hand_ = true;
        }
        if (view.map) rendition.map = *view.map;
        if (view.palette) rendition.palette = *view.palette;
        if (view.polarization) rendition.polarization = *view.polarization;
        if (view.gather) view_.gather = *view.gather;
        if (view.analyzer) {
            rendition.analyzer = *view.analyzer;
            view_.analyzer_angle = view.analyzer->angle;
        }
    } catch (const std::exception& error) {
        shown_.complaint = std::string("the view in the clipboard is none of this scene: ") + error.what();
    }
}

void Viewer::turn_analyzer(double degrees) {
    view_.analyzer_angle = in_half_turn(view_.analyzer_angle + degrees);
    view_.rendition.analyzer = {Analyzer::Kind::linear, view_.analyzer_angle};
}

void Viewer::pick_material() {
    const glm::ivec2 size = picture_size();
    const glm::vec2 place = window_.pointer();
    const auto met = seen_surface(*scene_, *rays_, view_.camera.position,
                                  ray_direction(view_.camera, size.x, size.y, place.x, place.y));
    if (!met) return notice("there is nothing under the pointer");
    shown_.material = static_cast<int>(met->material);
    shown_.lamp = -1;
    shown_.scroll_to_material = true;
    preferences_.panels = true;
    notice("material: " + scene_->materials[met->material].name);
}

void Viewer::frame_selection() {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const Triangle& triangle : scene_->triangles) {
        const std::uint32_t chart = triangle.front_chart != no_chart ? triangle.front_chart : triangle.back_chart;
        if (shown_.material >= 0 &&
            (chart == no_chart || scene_->charts[chart].material != static_cast<std::uint32_t>(shown_.material)))
            continue;
        for (const std::uint32_t vertex : triangle.vertices) {
            low = glm::min(low, scene_->vertices[vertex]);
            high = glm::max(high, scene_->vertices[vertex]);
        }
    }
    if (low.x <= high.x) go_to(framed(view_.camera, 0.5f * (low + high), 0.5f * glm::length(high - low)));
}

void Viewer::close_topmost() {
    if (!shown_.complaint.empty()) return shown_.complaint.clear();
    if (shown_.help || shown_.files) {
        (shown_.help ? shown_.help : shown_.files) = false;
        return;
    }
    if (preferences_.first_run) {
        preferences_.first_run = false;
        return;
    }
    if (taken_) {
        taken_.reset();
        return notice("the picture was not saved");
    }
    if (region_) return region_.reset();
    shown_.material = shown_.lamp = -1;
}

void Viewer::act(Action action, int argument) {
    Rendition& rendition = view_.rendition;
    must_present_ = true;
    switch (action) {
        case Action::polarization:
        case Action::compare:
            if (view_.split) return notice("the split shows polarization on and off; V ends it");
            if (action == Action::compare)
                comparing_ = true;
            else
                rendition.polarization = !rendition.polarization;
            break;
        case Action::split:
            view_.split = !view_.split;
            break;
        case Action::difference:
            rendition.map = rendition.map == Map::difference ? Map::radiance : Map::difference;
            if (rendition.map == Map::difference)
                notice("what polarization adds and takes; E shows weaker differences");
            break;
        case Action::analyzer:
            rendition.analyzer.kind =
                rendition.analyzer.kind == Analyzer::Kind::none ? Analyzer::Kind::linear : Analyzer::Kind::none;
            rendition.analyzer.angle = view_.analyzer_angle;
            break;
        case Action::turn_analyzer:
            turn_analyzer(argument);
            break;
        case Action::map:
            rendition.map = map_descriptions[static_cast<std::size_t>(argument)].map;
            break;
        case Action::exposure:
            rendition.exposure += static_cast<float>(argument) / 3;
            exposure_settled_ = exposure_by_hand_ = true;
            break;
        case Action::fit_exposure:
            if (canvas_.picture().bins()) rendition.exposure = canvas_.picture().exposure_of(scene_->cameras.front());
            break;
        case Action::next_camera: {
            const auto count = static_cast<int>(scene_->cameras.size());
            int at = 0;
            for (int i = 0; i < count; ++i)
                if (scene_->cameras[static_cast<std::size_t>(i)].name == home_camera_) at = i;
            go_to(scene_->cameras[static_cast<std::size_t>((at + argument + count) % count)]);
            home_camera_ = view_.camera.name;
            break;
        }
        case Action::store_view:
            kept_views_[static_cast<std::size_t>(argument - 1)] = view_;
            notice("view " + std::to_string(argument) + " kept; Alt+" + std::to_string(argument) + " goes back to it");
            break;
        case Action::recall_view: {
            const std::optional<Sight>& kept = kept_views_[static_cast<std::size_t>(argument - 1)];
            if (!kept)
                return notice("no view was kept as " + std::to_string(argument) + "; Ctrl+" + std::to_string(argument) +
                              " keeps one");
            const float exposure = rendition.exposure;
            view_ = *kept;
            // Of the scene, and perhaps not known well when the view was kept.
            if (!exposure_by_hand_) rendition.exposure = exposure;
            navigation_.release();
            break;
        }
        case Action::home:
            navigation_.set_pivot({});
            go_to(scene_->camera(home_camera_));
            break;
        case Action::frame:
            frame_selection();
            break;
        case Action::look_along: {
            constexpr std::array<glm::vec3, 5> forward = {glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0), glm::vec3(0, -1, 0),
                                                          glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)};
            go_to(looking_along(view_.camera, forward[static_cast<std::size_t>(argument)], scene_->radius()));
            break;
        }
        case Action::gather:
            view_.gather = !view_.gather;
            break;
        case Action::pause:
            session_.paused() ? session_.resume() : session_.pause();
            break;
        case Action::restart:
            session_.restart();
            break;
        case Action::inspector:
            shown_.inspector = !shown_.inspector;
            if (shown_.inspector) preferences_.panels = true;
            break;
        case Action::pick_material:
            pick_material();
            break;
        case Action::panels:
            preferences_.panels = !preferences_.panels;
            break;
        case Action::panel_field:
            preferences_.panels = shown_.wants_field = true;
            break;
        case Action::open:
            shown_.files = true;
            break;
        case Action::undo:
            session_.can_undo() ? session_.undo() : notice("there is nothing to undo");
            break;
        case Action::redo:
            session_.can_redo() ? session_.redo() : notice("there is nothing to do again");
            break;
        case Action::copy_view:
            window_.set_clipboard(words());
            notice("the view is in the clipboard; brewster shot --view takes it");
            break;
        case Action::paste_view:
            go_to_words(window_.clipboard());
            break;
        case Action::help:
            shown_.help = !shown_.help;
            break;
        case Action::full_screen:
            window_.toggle_full_screen();
            break;
        case Action::picture:
            take_picture(new_path(".png"), argument == 0);
            break;
        case Action::close:
            close_topmost();
            break;
        case Action::quit:
            quit_ = true;
            break;
    }
}

}  // namespace brewster
