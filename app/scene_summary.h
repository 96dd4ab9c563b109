#pragma once
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace brewster {

std::string_view lamp_kind_name(LampKind kind);
std::string_view lamp_intensity_unit(LampKind kind);

/// What a scene holds, for people: sizes, materials, lamps with their power, cameras, what is not simulated.
std::string scene_summary(const Scene& scene);

}  // namespace brewster
