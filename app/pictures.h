#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/eye_pictures.h"
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

/// What was found while pictures were made.
struct PicturesResult {
    float exposure = 0;                  ///< of the PNG ones, in EV
    std::optional<GatherResult> gather;  ///< none: drawn from the bins alone
};

/// Draws the pictures without a display and writes them; from the bins alone where there is no `eye`, which must have
/// been shown the bins.
PicturesResult write_pictures(const Scene& scene, std::shared_ptr<const Snapshot> bins, const ShotOptions& options,
                              const std::vector<PictureName>& pictures, EyePictures* eye);

}  // namespace brewster
