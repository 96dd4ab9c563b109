#pragma once
#include <memory>
#include <string>

#include "app/options.h"
#include "engine/engine.h"
#include "scene/scene.h"

namespace brewster {

/// Reads the scene (an empty path: the one in the binary), changes it as wished, and passes its warnings on, as warnings
/// of the program.
std::shared_ptr<const Scene> load_scene(const std::string& path, const std::vector<Setting>& settings);

/// An engine and the scene that it traces.
struct Solution {
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<Engine> engine;
};

/// The saved solution `options.resume`, taken up. Reads the scene as load_scene does, and changes it as it was changed.
Solution saved_solution(const SolveOptions& options);

/// The engine that the options ask for: new, or with a saved solution taken up.
std::unique_ptr<Engine> engine_for(const SolveOptions& options);

/// Traces until the rule holds (an empty one: default_photons) or someone presses Ctrl+C, with a progress bar where
/// standard error is a terminal. Counts of the rule are of this call. Throws Error when not
/// a single photon was traced.
void trace(Engine& engine, const StopRule& rule);

/// The same in parts, of which more may follow: nothing is said. False when Ctrl+C ended it.
bool trace_on(Engine& engine, const StopRule& rule);
/// What is to be said when no more follows; throws like trace.
void finish_trace(const Engine& engine, bool interrupted);

}  // namespace brewster
