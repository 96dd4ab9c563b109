#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// Lamps, by name, that shine but start fewer than ten of so many photons, since photons go by power: what they light alone
/// is dark in the bins, without an error bar that says so.
std::vector<std::string> faint_lamps(const Scene& scene, double photons);

}  // namespace brewster
