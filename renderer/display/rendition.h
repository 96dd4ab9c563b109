#pragma once
#include <cmath>
#include <glm/vec4.hpp>

#include "base/units.h"
#include "display/maps.h"

namespace brewster {

/// An ideal filter in front of the camera.
struct Analyzer {
    enum class Kind { none, linear, right, left };
    Kind kind = Kind::none;
    double angle = 0;  ///< linear: degrees from the picture's horizontal, counter-clockwise as the camera sees it

    friend bool operator==(const Analyzer&, const Analyzer&) = default;

    /// S1, S2, S3 of the light that passes whole, and 1; all zero without an analyzer (shaders/shared/stokes.h).
    glm::vec4 passing() const {
        if (kind == Kind::none) return glm::vec4(0.0f);
        if (kind != Kind::linear) return {0.0f, 0.0f, kind == Kind::right ? 1.0f : -1.0f, 1.0f};
        const double twice = 2 * radians(angle);
        return {static_cast<float>(std::cos(twice)), static_cast<float>(std::sin(twice)), 0.0f, 1.0f};
    }
};

/// How linear light becomes what the screen shows. None of it needs new photons.
struct Rendition {
    Map map = Map::radiance;
    Analyzer analyzer;         ///< maps look at what it lets through
    bool polarization = true;  ///< off: the world where no surface can tell polarizations apart
    float exposure = 0;        ///< EV
    Palette palette = Palette::blue_orange;

    friend bool operator==(const Rendition&, const Rendition&) = default;

    /// The difference always looks at both worlds.
    bool shows_polarized_world() const { return polarization || map == Map::difference; }
    bool shows_unpolarized_world() const { return !polarization || map == Map::difference; }
};

}  // namespace brewster
