#pragma once
#include <string>
#include <vector>

#include "engine/engine.h"

namespace brewster {

/// What `--variant` may name: habits of the 1997 method in place of the engine's, one at a time and all together.
std::vector<std::string> variant_names();

/// Settings of that variant; false where there is none of the name.
bool take_variant(const std::string& name, EngineSettings& settings);

}  // namespace brewster
