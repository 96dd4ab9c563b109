#pragma once
#include <memory>

#include "app/options.h"
#include "gather/gather.h"

namespace brewster {

/// What gathering took.
struct GatherResult {
    double draws = 0;         ///< per pixel, mean over the pictures
    double seconds = 0;       ///< of all pictures
    double coarse_share = 0;  ///< of the light, what came from bins of gloss at the end of long paths
};

/// Pictures by the eye's own rays (renderer/gather), one camera after the other.
class EyePictures {
  public:
    EyePictures(const Scene& scene, std::shared_ptr<const Snapshot> bins, const ShotOptions& options);

    /// What the camera sees; drawn when another one than before is asked for. Ctrl+C ends the drawing with what there is.
    const StokesPicture& of(const Camera& camera);

    GatherResult result() const;

  private:
    const ShotOptions& options_;
    Gather gather_;
    unsigned threads_;
    std::string camera_;  // of the picture
    StokesPicture picture_;
    int pictures_ = 0;
    GatherResult sums_;
};

}  // namespace brewster
