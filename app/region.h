#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// A mask, one byte a pixel, of the pixels that show nothing but the named meshes: their middle and four corners do.
/// An unknown camera or mesh is an Error that lists the names there are.
std::vector<std::uint8_t> region_mask(const Scene& scene, const std::string& camera,
                                      const std::vector<std::string>& meshes, int width, int height);

}  // namespace brewster
