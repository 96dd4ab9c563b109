#include "app/viewer.h"

#include <algorithm>
#include <chrono>

#include "app/motion_resolution.h"
#include "app/navigation.h"
#include "app/seen_point.h"
#include "display/legend.h"
#include "display/picture.h"
#include "display/screen_pass.h"
#include "display/text.h"

namespace brewster {
namespace {

constexpr double rest_after = 0.15;         ///< seconds without motion
constexpr double idle_wait = 0.1;           ///< seconds until the next look for new bins
constexpr double progress_interval = 0.25;  ///< seconds
/// New bins begin a new mean. Until it has so many draws the old picture stays, so that edges do not flicker, and no
/// newer bins are taken, so that it gets there however slow the drawing is.
constexpr int draws_before_change = 8;
/// A frame that takes longer than this was drawn by the processor, which the photons need too: at rest three times as
/// long is left to them before the next.
constexpr double slow_frame = 0.02;  ///< seconds
constexpr std::uint64_t photons_of_settled_exposure = 1000000;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Viewer {
  public:
    Viewer(Window& window, const Scene& scene, const LightSource& light, const ViewerOptions& options)
        : window_(window),
          scene_(scene),
          light_(light),
          options_(options),
          rays_(scene),
          picture_(scene),
          navigation_([this](const Camera& camera, glm::vec2 place) { return seen(camera, place); }, scene.radius()),
          exposure_settled_(options.exposure.has_value()) {
        const Camera& first = options.camera.empty() ? scene.cameras.front() : scene.camera(options.camera);
        camera_index_ = static_cast<std::size_t>(&first - scene.cameras.data());
        camera_ = first;
        rendition_.exposure = options.exposure.value_or(0.0f);
    }

    void run() {
        while (!quit_ && !window_.close_requested()) {
            if (!busy()) {
                window_.wait_events(idle_wait);
            } else if (pause_ > 0) {
                window_.wait_events(pause_);
            } else {
                window_.poll_events();
            }
            for (const InputEvent& event : window_.take_events()) handle(event);
            take_bins();
            take_progress();
            if (window_.take_damage()) must_present_ = true;
            const glm::ivec2 size = window_.framebuffer_size();
            minimised_ = size.x < 1 || size.y < 1;
            if (!minimised_) draw(size);
        }
    }

  private:
    bool moving() const { return now() - last_motion_ < rest_after; }
    int wanted_draws() const { return picture_.bins() ? Picture::full_draws : 1; }
    bool busy() const {
        return !minimised_ &&
               (must_present_ || !picture_.uploaded() || moving() || picture_.draws(rendition_) < wanted_draws());
    }

    std::optional<glm::vec3> seen(const Camera& camera, glm::vec2 place) const {
        const glm::ivec2 size = window_.framebuffer_size();
        return seen_point(rays_, camera.position, ray_direction(camera, size.x, size.y, place.x, place.y));
    }

    void handle(const InputEvent& event) {
        if (event.kind == InputEvent::Kind::key_press) return press(event);
        const glm::ivec2 size = window_.framebuffer_size();
        if (size.x < 1 || size.y < 1) return navigation_.release();
        const Camera before = camera_;
        camera_ = navigation_.moved(camera_, event, size);
        if (camera_.position != before.position || camera_.forward != before.forward) {
            moved_ = true;
            last_motion_ = now();
            draws_to_present_ = 1;
        }
    }

    void press(const InputEvent& event) {
        const std::size_t count = scene_.cameras.size();
        if (event.key == Key::q && event.control) quit_ = true;
        if (event.key == Key::n) choose_camera((camera_index_ + (event.shift ? count - 1 : 1)) % count);
        if (event.key == Key::home) choose_camera(camera_index_);
        if (event.key == Key::p && picture_.bins()) {
            rendition_.polarization = !rendition_.polarization;
            draws_to_present_ = 1;
            must_present_ = true;
        }
    }

    void choose_camera(std::size_t index) {
        camera_index_ = index;
        camera_ = scene_.cameras[index];
        moved_ = false;
        navigation_.release();
        draws_to_present_ = 1;
    }

    void take_bins() {
        const bool first = !picture_.bins();
        if (first || moving() || picture_.draws(rendition_) >= draws_before_change) {
            if (std::shared_ptr<const Snapshot> bins = light_.snapshot()) picture_.show(std::move(bins));
        }
        if (picture_.uploaded() || !picture_.upload(Picture::frame_bytes)) return;
        draws_to_present_ = first || moving() ? 1 : draws_before_change;
        if (exposure_settled_) return;
        rendition_.exposure = picture_.exposure_of(scene_.cameras.front());
        exposure_settled_ = picture_.bins()->photons >= photons_of_settled_exposure;
    }

    void take_progress() {
        if (now() - last_progress_ < progress_interval) return;
        last_progress_ = now();
        std::string line = light_.progress();
        if (line == progress_) return;
        progress_ = std::move(line);
        progress_changed_ = true;
    }

    void draw(glm::ivec2 size) {
        const double begin = now();
        const bool in_motion = moving();
        const int shrink = in_motion && resolution_.half() ? 2 : 1;
        picture_.look(camera_, (size.x + shrink - 1) / shrink, (size.y + shrink - 1) / shrink);
        const bool drawn = picture_.draws(rendition_) < wanted_draws();
        if (drawn) picture_.draw(1, rendition_);
        const bool ready = picture_.draws(rendition_) >= draws_to_present_;
        if (must_present_ || (ready && (drawn || progress_changed_))) {
            present(size);
            must_present_ = progress_changed_ = false;
        } else {
            picture_.finish();
        }
        const double took = now() - begin;
        pause_ = !in_motion && drawn && took > slow_frame ? 3 * took : 0;
        if (in_motion && drawn) resolution_.frame_took(took);
    }

    void present(glm::ivec2 size) {
        const Screen screen = Screen::window(size.x, size.y);
        screen_pass_.show(screen, picture_.light(), rendition_);
        const int text_size = std::clamp(size.y / 45, 12, 32);
        if (!progress_.empty()) text_.add_label(progress_, glm::vec2(0.5f * static_cast<float>(text_size)), text_size);
        text_.draw(screen);
        if (options_.legend && picture_.bins()) {
            const std::string name = camera_.name + (moved_ ? " (moved)" : "");
            draw_legend(text_, screen, {rendition_, scene_.name, name, picture_.bins()->photons});
        }
        window_.swap();
    }

    Window& window_;
    const Scene& scene_;
    const LightSource& light_;
    const ViewerOptions& options_;
    Rays rays_;
    Picture picture_;
    ScreenPass screen_pass_;
    Rendition rendition_;
    Text text_;
    Navigation navigation_;
    MotionResolution resolution_;
    Camera camera_;
    std::size_t camera_index_ = 0;
    bool moved_ = false;  ///< the camera is no longer where the file has it
    bool exposure_settled_;
    std::string progress_;
    bool progress_changed_ = false, must_present_ = true, minimised_ = false, quit_ = false;
    int draws_to_present_ = 1;
    double last_motion_ = -1e9, last_progress_ = -1e9;
    double pause_ = 0;  ///< seconds before the next frame
};

}  // namespace

void view(Window& window, const Scene& scene, const LightSource& light, const ViewerOptions& options) {
    Viewer(window, scene, light, options).run();
}

}  // namespace brewster
