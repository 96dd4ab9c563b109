#include <cstdlib>

#include "app/trace.h"
#include "app/verbs.h"
#include "base/log.h"

namespace brewster {
namespace {

/// Why no window can be opened.
std::string obstacle(const ViewerOptions& options) {
    if (options.headless) return "--headless was asked for";
    if (std::getenv("DISPLAY") == nullptr) return "no display: DISPLAY is not set";
    return "the window is not built yet";
}

}  // namespace

void view(const ViewerOptions& options) {
    const std::shared_ptr<const Scene> scene = load_scene(options.scene);
    log_info(obstacle(options) + "; pictures of all cameras go to ./pictures");
    ShotOptions pictures;
    pictures.solve.stop = options.stop;
    pictures.solve.engine = options.engine;
    shot(scene, pictures);
}

}  // namespace brewster
