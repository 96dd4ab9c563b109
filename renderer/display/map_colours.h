#pragma once
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The C++ side of the maps; the formulas stand in shaders/shared/stokes.h, the colours in shaders/shared/map_colours.h.
namespace brewster::maps {

using glm::atan, glm::clamp, glm::fract, glm::max, glm::min, glm::mix;
using glm::vec3, glm::vec4;
using std::abs, std::cos, std::log2, std::sqrt;
using uint = std::uint32_t;

#define BREWSTER_FUNCTION inline
#include "shared/map_colours.h"
#include "shared/stokes.h"
#undef BREWSTER_FUNCTION

}  // namespace brewster::maps
