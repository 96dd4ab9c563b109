#pragma once
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "image/image.h"

namespace brewster {

/// The C++ side of the tone curve; the formulas stand in shaders/shared/tone.h.
namespace tone {

using glm::max, glm::min;
using glm::vec3;
using std::exp2, std::pow;

#define BREWSTER_FUNCTION inline
#include "shared/tone.h"
#undef BREWSTER_FUNCTION

}  // namespace tone

/// The exposure in EV that brings the log-mean of the greatest band of the lit pixels to a linear screen value of 0.18,
/// rounded to 0.1 EV so that noise hardly moves it. Pixels below 1e-4 of the mean count as that much; black ones not at
/// all. A picture without any light gives 0. Needs S0.R S0.G S0.B.
float auto_exposure(const Image& radiance);

}  // namespace brewster
