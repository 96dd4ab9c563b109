#pragma once
#include <vector>

#include "bins/outline.h"
#include "scene/scene.h"

namespace brewster {

/// What the bins need to know of a scene: the shape of every chart in its own coordinates, and the lines on it along
/// which other surfaces meet it.
std::vector<Outline> outlines_of(const Scene& scene);

}  // namespace brewster
