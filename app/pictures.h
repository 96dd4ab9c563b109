#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/eye_pictures.h"
#include "app/options.h"
#include "app/picture_names.h"
#include "bins/snapshot.h"
#include "image/image.h"
#include "scene/scene.h"

namespace brewster {

/// The wished size, or default_picture_height rows and columns by the camera's shape.
PictureSize size_for(const Camera& camera, const std::optional<PictureSize>& wished);

/// What a picture file says of itself.
struct PictureDescription {
    std::string scene, camera;
    std::uint64_t photons = 0;
    bool polarization = true;  ///< the world it holds
    std::uint64_t seed = 1;
    bool gather = true;
    float exposure = 0;  ///< EV
};
/// As attributes, from which `brewster develop` makes pictures for the eye.
void describe_picture(Image& stokes, const PictureDescription& picture);

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
