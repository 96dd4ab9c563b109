// What the window writes into files.
#include <algorithm>
#include <exception>
#include <filesystem>

#include "app/clock.h"
#include "app/view_text.h"
#include "app/viewer.h"

namespace brewster {
namespace {

constexpr double seconds_between_shares = 0.25;

}  // namespace

std::string Viewer::name_of(const Camera& camera) const {
    const bool moved = std::any_of(scene_->cameras.begin(), scene_->cameras.end(), [&](const Camera& known) {
        return known.name == camera.name && !same_pose(known, camera);
    });
    return camera.name + (moved ? " (moved)" : "");
}

std::string Viewer::new_path(const std::string& kind) const {
    std::string path;
    for (int number = 1; path.empty() || std::filesystem::exists(path); ++number)
        path = scene_->name + "-" + view_.camera.name + "-" + std::to_string(number) + kind;
    return path;
}

void Viewer::save_solution(const std::string& path) {
    if (!session_.snapshot()) return notice("there is no light yet to save");
    if (session_.saving()) return notice("still saving " + solution_path_);
    solution_path_ = path;
    session_.save(path);
    notice("saving " + path);
}

void Viewer::take_saved_solution() {
    const std::optional<std::string> saved = session_.take_saved();
    if (!saved) return;
    if (saved->empty()) return notice("saved " + std::filesystem::absolute(solution_path_).string());
    shown_.complaint = *saved;
    must_present_ = true;
}

void Viewer::take_picture(const std::string& path, bool legend) {
    const auto bins = session_.snapshot();
    if (!bins) return notice("there is no light yet to take a picture of");
    if (taken_) return notice("still saving " + taken_->path());
    const glm::ivec2 size = picture_size();
    const std::uint64_t seed = session_.engine()->settings().seed;
    shown_.notice.clear();
    // Rays at rest would only be in its way.
    gatherer_.stop();
    // What the copied words say: a moved camera loses its last bits on the way through text.
    Sight view = view_;
    view.camera = camera_of(*scene_, parse_view(words()));
    view.camera.name = name_of(view_.camera);
    taken_ =
        std::make_unique<TakenPicture>(TakenPicture::Order{path, scene_, bins, view, size.x, size.y, seed, legend});
}

std::string Viewer::taking_words() const {
    return "saving " + taken_->path() + ": " + std::to_string(static_cast<int>(100 * taken_->share())) +
           " % of its samples; Esc ends it";
}

void Viewer::advance_taken_picture() {
    if (!taken_) return;
    try {
        if (!taken_->advance()) {
            if (seconds_now() - last_present_ >= seconds_between_shares && taking_words() != said_of_taking_)
                must_present_ = true;
            return;
        }
        notice("saved " + std::filesystem::absolute(taken_->path()).string());
    } catch (const std::exception& error) {
        shown_.complaint = error.what();
    }
    taken_.reset();
    must_present_ = true;
}

}  // namespace brewster
