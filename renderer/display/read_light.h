#pragma once
#include <glm/vec2.hpp>

#include "display/light_textures.h"
#include "image/stokes_picture.h"

namespace brewster {

/// Fetches pixels [low, high), counted from the upper left, of a picture of so many rows. Both must lie inside it. Waits for what was drawn.
StokesPicture read_light(const LightTextures& light, int rows, glm::ivec2 low, glm::ivec2 high);

}  // namespace brewster
