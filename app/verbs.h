#pragma once
#include <memory>

#include "app/options.h"
#include "scene/scene.h"

namespace brewster {

/// The verbs of the command line, each in the file of its name. Results go to standard output, messages to standard
/// error; what fails throws Error.
void solve(const SolveOptions& options);
void shot(const ShotOptions& options);
void shot(Engine& engine, const ShotOptions& options);  ///< of an engine that stands ready
void develop(const DevelopOptions& options);
void info(const InfoOptions& options);
void make_reference(const ReferenceOptions& options);
void compare_pictures(const CompareOptions& options);
void open_scene(const OpenOptions& options);  ///< without a verb: the window, or pictures where there is none

}  // namespace brewster
