#include <glm/vec2.hpp>

#include "app/numbers.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "app/viewer.h"
#include "app/window.h"
#include "base/error.h"
#include "base/log.h"

namespace brewster {
namespace {

constexpr glm::ivec2 first_window_size{1024, 768};
constexpr double seconds_between_snapshots = 0.5;

/// Null where no window can be opened; `obstacle` then says why.
std::unique_ptr<Window> open_window(const Scene& scene, std::string& obstacle) {
    try {
        return std::make_unique<Window>("Brewster: " + scene.name, first_window_size);
    } catch (const Error& error) {
        obstacle = error.what();
        return nullptr;
    }
}

std::string progress_words(Engine& engine) {
    const bool done = engine.wait_for(0);  // throws what a worker failed of
    const Progress progress = engine.progress();
    return with_magnitude(static_cast<double>(progress.photons)) + " photons" +
           (done ? ", done" : ", " + with_magnitude(progress.photons_per_second()) + " a second");
}

void show(Window& window, const std::shared_ptr<const Scene>& scene, const OpenOptions& options) {
    EngineSettings settings = options.engine;
    settings.lowest_priority = true;
    settings.snapshot_seconds = seconds_between_snapshots;
    Engine engine(scene, settings);
    engine.start(options.stop);
    view(window, *scene, {[&] { return engine.snapshot(); }, [&] { return progress_words(engine); }}, {});
    engine.stop();
}

}  // namespace

void open_scene(const OpenOptions& options) {
    const std::shared_ptr<const Scene> scene = load_scene(options.scene, options.settings);
    std::string obstacle = "--headless was asked for";
    if (!options.headless) {
        if (const std::unique_ptr<Window> window = open_window(*scene, obstacle)) {
            return show(*window, scene, options);
        }
    }
    log_info(obstacle + "; pictures of all cameras go to ./pictures");
    ShotOptions pictures;
    pictures.solve.stop = options.stop;
    pictures.solve.engine = options.engine;
    Engine engine(scene, options.engine);
    shot(engine, pictures);
}

}  // namespace brewster
