#pragma once
#include <string>

#include "engine/engine.h"

namespace brewster {

/// How near the engine is to stopping, in [0, 1]: the largest share of any part of the rule. The error counts as the
/// inverse square root of the photons.
double finished_share(const Progress& progress, const StopRule& rule);

/// One line for a terminal: bar, photons, speed, and the error where it is what stops the run.
std::string progress_line(const Progress& progress, const StopRule& rule);

}  // namespace brewster
