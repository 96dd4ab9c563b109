#include <glm/vec2.hpp>

#include "app/clock.h"
#include "app/memory.h"
#include "app/trace.h"
#include "app/verbs.h"
#include "app/viewer.h"
#include "app/window.h"
#include "base/error.h"
#include "base/log.h"

namespace brewster {
namespace {

constexpr glm::ivec2 first_window_size{1280, 800};

/// Null where no window can be opened; `obstacle` then says why.
std::unique_ptr<Window> open_window(const Scene& scene, std::string& obstacle) {
    try {
        return std::make_unique<Window>("Brewster: " + scene.name, first_window_size);
    } catch (const Error& error) {
        obstacle = error.what();
        return nullptr;
    }
}

}  // namespace

void open_scene(const OpenOptions& options) {
    const double started = seconds_now();
    const std::shared_ptr<const Scene> scene = load_scene(options.scene, options.settings);
    std::string obstacle = "--headless was asked for";
    if (!options.headless) {
        keep_large_blocks_apart();
        if (const std::unique_ptr<Window> window = open_window(*scene, obstacle)) {
            Viewer viewer(*window, scene, options, started);
            if (!viewer.run()) throw Error("it found what it did not expect", options.replay, "see its report");
            // Threads of low priority may end late where other programs keep the processor.
            window->hide();
            return;
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
