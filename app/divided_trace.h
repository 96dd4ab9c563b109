#pragma once
#include <span>

#include "app/eye_pictures.h"
#include "app/options.h"
#include "engine/engine.h"

namespace brewster {

/// Traces photons for pictures that are drawn afterwards, of these cameras. Where seconds or a target error are asked for,
/// they are of photons and draws together: time goes to either by its share of the error, as trial pictures of the first
/// photons show it. Returns when the pictures are done. Throws Error when not a single photon was traced.
DrawRule trace_for_pictures(Engine& engine, EyePictures& eye, std::span<const Camera* const> cameras,
                            const ShotOptions& options);

}  // namespace brewster
