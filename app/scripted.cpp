// The window as scripts see it.
#include <nlohmann/json.hpp>

#include "app/clock.h"
#include "app/settings.h"
#include "app/viewer.h"
#include "base/error.h"

namespace brewster {

Stage Viewer::make_stage() {
    using nlohmann::json;
    Stage stage;
    stage.input = [this](const InputEvent& event) {
        overlay_.script(event);
        window_.script(event);
    };
    stage.type = [this](const std::string& text) { overlay_.script_text(text); };
    stage.set = [this](const std::string& text) {
        const std::optional<Setting> setting = parse_setting(text);
        if (!setting) throw Error("'" + text + "' is not of the form MATERIAL.PROPERTY=VALUE", "script", "correct it");
        auto changed = std::make_shared<Scene>(*session_.scene());
        apply_settings(*changed, {*setting});
        session_.change(std::move(changed), *setting, true);
    };
    stage.open = [this](const std::string& path) { file_.open(path); };
    stage.save = [this](const std::string& path) { take_picture(path, true); };
    stage.save_solution = [this](const std::string& path) { save_solution(path); };
    stage.resize = [this](int width, int height) { window_.resize({width, height}); };
    stage.minimise = [this](bool minimised) { window_.minimise(minimised); };
    stage.make_flat = [this](bool flat) {
        canvas_.picture().make_flat(flat);
        keeps_resolution_ = flat;
    };
    stage.capture = [this](const std::string& path) {
        wanted_capture_ = path;
        must_present_ = true;
    };
    stage.state = [this] {
        const Progress progress = session_.engine() ? session_.engine()->progress() : Progress{};
        const glm::ivec2 size = picture_size();
        const Rendition& rendition = view_.rendition;
        const glm::vec3 eye = view_.camera.position;
        return json{
            {"milliseconds", 1000 * (seconds_now() - started_)},
            {"scene", scene_->name},
            {"picture", {size.x, size.y}},
            {"polarization", rendition.polarization != comparing_},
            {"map", description(rendition.map).name},
            {"analyzer", static_cast<int>(rendition.analyzer.kind)},
            {"angle", view_.analyzer_angle},
            {"exposure", rendition.exposure},
            {"split", view_.split},
            {"gather", view_.gather},
            {"camera", view_.camera.name},
            {"eye", {eye.x, eye.y, eye.z}},
            {"hidden", hidden_},
            {"moving", moving()},
            {"half", resolution_.half()},
            {"bare", !canvas_.settled() && !canvas_.picture().shows_glimpse()},
            {"generation", session_.generation()},
            {"stale", session_.stale() || bins_generation_ != session_.generation()},
            {"bins", canvas_.picture().bins() != nullptr},
            {"photons", progress.photons},
            {"error", progress.relative_error},
            {"running", progress.running},
            {"paused", session_.paused()},
            {"draws", canvas_.picture().draws(Canvas::needed(view_, comparing_))},
            {"gathered", canvas_.settled() ? canvas_.gathered()->samples() : 0.0},
            {"gathered_share", canvas_.gathered() ? canvas_.gathered()->share() : 0.0},
            {"panels", preferences_.panels},
            {"text_scale", preferences_.text_scale},
            {"typing", overlay_.wants_text()},
            {"help", shown_.help},
            {"files", shown_.files},
            {"inspector", shown_.inspector},
            {"material", shown_.material >= 0 ? scene_->materials[static_cast<std::size_t>(shown_.material)].name : ""},
            {"complaint", shown_.complaint},
            {"notice", shown_.notice},
            {"undo", session_.can_undo()},
            {"reading", file_.reading()},
            {"saving", taken_ != nullptr || session_.saving()},
            {"saved_share", taken_ ? taken_->share() : 0.0},
            {"words", words()},
            {"dolp", light_ ? light_->dolp() : -1.0},
            {"radiance", light_ ? light_->mean()[0] : -1.0},
            {"surface", surface_ ? scene_->charts[surface_->chart].mesh : ""}};
    };
    return stage;
}

void Viewer::record(const InputEvent& event) {
    const double now = seconds_now(), after = last_recorded_ > 0 ? now - last_recorded_ : 0;
    record_ << (last_recorded_ > 0 ? ",\n" : "{\"steps\": [\n") << step_of(event, after, glm::vec2(picture_size()));
    last_recorded_ = now;
}

}  // namespace brewster
