#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "app/picture_names.h"
#include "bins/snapshot.h"
#include "scene/scene.h"

namespace brewster {

/// The wished size, or default_picture_height rows and columns by the camera's shape.
PictureSize size_for(const Camera& camera, const std::optional<PictureSize>& wished);

/// The pictures that `options` ask for of this scene, their folders made. Throws Error for an unknown camera and for
/// names that cannot be written, so that it comes before the work.
std::vector<PictureName> plan_pictures(const Scene& scene, const ShotOptions& options);

/// Draws the pictures without a display and writes them. Returns the exposure of the PNG ones, in EV.
float write_pictures(const Scene& scene, std::shared_ptr<const Snapshot> bins, const ShotOptions& options,
                     const std::vector<PictureName>& pictures);

}  // namespace brewster
