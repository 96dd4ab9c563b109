#pragma once
#include <cmath>

#include "base/units.h"
#include "reference/hand_made.h"
#include "scene/test_materials.h"

namespace brewster {

/// Two smooth faces of index n met at `theta` (radians), the second plane of incidence turned by `psi`, a lamp of
/// radiance 1 behind; seen by a view so narrow that no randomness is left.
struct TwoMirrors {
    std::shared_ptr<const Scene> scene;
    Camera camera;
};

inline TwoMirrors two_mirrors(double n, double theta, double psi) {
    HandMade room;
    const auto mirror = room.add(test_materials::dielectric(Base::black, glm::vec3(static_cast<float>(n))));
    const auto lamp = room.add(emitter(glm::vec3(1.0f)));
    // From the camera down to the first face, up to the second, on to the lamp.
    const glm::dvec3 first(std::sin(theta), 0, -std::cos(theta)), second(std::sin(theta), 0, std::cos(theta));
    const glm::dvec3 in_plane(-std::cos(theta), 0, std::sin(theta)), across(0, 1, 0);
    const glm::dvec3 normal =
        -std::cos(theta) * second + std::sin(theta) * (std::cos(psi) * in_plane + std::sin(psi) * across);
    const glm::dvec3 third = second - 2.0 * glm::dot(second, normal) * normal;
    room.square("first", glm::dvec3(0.0), {0, 0, 1}, 0.5, mirror);
    room.square("second", 4.0 * second, normal, 0.5, mirror);
    room.square("lamp", 4.0 * second + 4.0 * third, -third, 1, lamp);
    return {room.finish(), looking(-4.0 * first, glm::dvec3(0.0), 0.01)};
}

}  // namespace brewster
