#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "scene/rays.h"

namespace brewster {

/// The first point on the ray that the eye sees: on a side with a chart, since backs that absorb are looked through.
std::optional<glm::vec3> seen_point(const Rays& rays, glm::vec3 eye, glm::vec3 direction);

/// What the ray meets there.
std::optional<Hit> seen_hit(const Rays& rays, glm::vec3 eye, glm::vec3 direction);

}  // namespace brewster
