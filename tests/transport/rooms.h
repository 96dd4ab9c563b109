#pragma once
#include <memory>
#include <string>

#include "scene/scene.h"

/// Scenes that the tests of transport and engine share.
namespace brewster::rooms {

inline std::shared_ptr<const Scene> read(const std::string& name) {
    return std::make_shared<const Scene>(read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/" + name));
}

}  // namespace brewster::rooms
