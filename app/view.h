#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "app/numbers.h"
#include "display/rendition.h"

namespace brewster {

/// A picture in words, as the command line and the clipboard know it: `camera=front size=640x480 map=dolp analyzer=30`.
/// What is not said stays as it is. Words: camera (a camera of the scene; beside eye and target, the view's name), eye,
/// target, up (x,y,z in the file's coordinates, metres), fov (degrees, of the height), size, ev, map, palette, analyzer,
/// polarization, gather, samples, seed. Values with spaces stand between double quotes.
struct View {
    struct Pose {
        glm::dvec3 eye{0.0}, target{0.0, 0.0, -1.0}, up{0.0, 1.0, 0.0};
        double field_of_view = 45;  ///< degrees

        friend bool operator==(const Pose&, const Pose&) = default;
    };
    std::string camera;
    std::optional<Pose> pose;
    std::optional<PictureSize> size;
    std::optional<double> exposure;  ///< EV
    std::optional<Map> map;
    std::optional<Palette> palette;
    std::optional<Analyzer> analyzer;
    std::optional<bool> polarization, gather;
    std::optional<int> samples;
    std::optional<std::uint64_t> seed;

    friend bool operator==(const View&, const View&) = default;
};

}  // namespace brewster
