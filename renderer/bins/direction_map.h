#pragma once
#include <cmath>
#include <glm/vec2.hpp>

/// The C++ side of the map of directions; the formula stands in shaders/shared/direction_map.h.
namespace brewster::direction_map {

using glm::vec2;
using std::abs, std::sqrt;

inline float min(float a, float b) {
    return b < a ? b : a;
}

#define BREWSTER_FUNCTION inline
#include "shared/direction_map.h"
#undef BREWSTER_FUNCTION

}  // namespace brewster::direction_map
