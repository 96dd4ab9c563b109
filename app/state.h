#pragma once
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "display/rendition.h"
#include "scene/camera.h"

namespace brewster {

/// From where and how the scene is looked at. Nothing here makes photons fly.
struct Sight {
    Camera camera;
    Rendition rendition;
    bool gather = true;         ///< at rest, rays of the eye's own
    bool split = false;         ///< polarization on to the left, off to the right
    float split_at = 0.5f;      ///< share of the picture's width
    double analyzer_angle = 0;  ///< degrees; kept while the analyzer is off

    /// Rays can show it: cells are not gathered.
    bool of_rays() const { return gather && rendition.map != Map::bins; }
};

/// An axis's angle in degrees, in (-90, 90].
inline double in_half_turn(double angle) {
    const double rest = std::fmod(angle, 180.0);
    return rest > 90 ? rest - 180 : rest <= -90 ? rest + 180 : rest;
}

inline bool operator==(const Sight& a, const Sight& b) {
    return same_pose(a.camera, b.camera) && a.camera.name == b.camera.name && a.rendition == b.rendition &&
           a.gather == b.gather && a.split == b.split && a.split_at == b.split_at &&
           a.analyzer_angle == b.analyzer_angle;
}

/// What is kept from one start of the program to the next.
struct Preferences {
    float text_scale = 1;  ///< 0.8 to 2
    bool light = false;
    bool panels = true;
    bool first_run = true;  ///< the card of three lines was not closed yet
    std::string palette = "blue-orange";
    std::vector<std::string> recent_files;  ///< newest first
    std::string folder;                     ///< where files were opened last
    bool operator==(const Preferences&) const = default;
};

/// Which things lie over the picture.
struct Shown {
    bool inspector = true, help = false, files = false;
    int material = -1;  ///< chosen in the list; -1: none
    int lamp = -1;
    bool scroll_to_material = false;
    bool wants_field = false;  ///< the keyboard goes to the panels' first field
    std::string complaint;     ///< one sentence, until it is closed
    std::string notice;        ///< one line that goes by itself
    double notice_until = 0;
};

}  // namespace brewster
