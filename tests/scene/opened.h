#pragma once
#include <algorithm>
#include <string>

#include "scene/gltf_builder.h"
#include "scene/scene.h"

namespace brewster {

/// What a file of tests becomes when it is opened.
inline Scene scene_of(const GltfBuilder& file) {
    return read_scene_text(file.text(), "test");
}

/// Whether a warning says these words.
inline bool warns_of(const Scene& scene, const std::string& words) {
    return std::any_of(scene.warnings.begin(), scene.warnings.end(),
                       [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

}  // namespace brewster
