#pragma once
#include <string>
#include <vector>

#include "bins/solution_file.h"
#include "engine/engine.h"

namespace brewster {

/// What a solution was traced with, and of what: with these an engine can take it up.
struct SavedSettings {
    std::string scene_name, scene_hash;
    std::uint64_t photons = 0;
    double seconds = 0;     ///< of tracing
    EngineSettings engine;  ///< changes, seed, bins, kernel and guiding; the rest stays as it is by default
};

SavedSettings saved_settings(const SolutionReader& file);

/// The block that `saved_settings` reads.
ByteWriter settings_block(const SavedSettings& settings);

}  // namespace brewster
