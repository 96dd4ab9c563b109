#pragma once
#include <string>

#include "scene/scene.h"

namespace brewster {

/// A 128-bit hash, hexadecimal, of everything in a scene that photons can tell: surfaces, materials, textures and lamps,
/// whatever file, buffers, pictures and changes they came from; not its cameras and names.
std::string scene_hash(const Scene& scene);

}  // namespace brewster
