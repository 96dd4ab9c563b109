#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/window.h"
#include "bins/snapshot.h"
#include "scene/scene.h"

namespace brewster {

/// What the viewer asks of whoever fills the bins, from its own thread and often.
struct LightSource {
    std::function<std::shared_ptr<const Snapshot>()> snapshot;  ///< the newest, or null before the first
    std::function<std::string()> progress;                      ///< one line for people
};

struct ViewerOptions {
    std::string camera;             ///< to begin with; empty: the first of the file
    std::optional<float> exposure;  ///< EV; none: from what the first camera of the file sees
    bool legend = true;
};

/// Shows the scene in the window until it is closed or Ctrl+Q is pressed. Mouse: see Navigation. N and Shift+N: next
/// and previous camera of the file; Home: back to where the camera stands in the file. Draws only when something has
/// changed, and at rest until the mean of 64 jittered draws is reached; then it waits.
void view(Window& window, const Scene& scene, const LightSource& light, const ViewerOptions& options);

}  // namespace brewster
