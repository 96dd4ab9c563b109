#pragma once
#include <memory>
#include <span>

#include "app/division.h"
#include "app/options.h"
#include "gather/gather.h"

namespace brewster {

/// What gathering took.
struct GatherResult {
    double draws = 0;         ///< per pixel, mean over the pictures
    double seconds = 0;       ///< of all pictures
    double coarse_share = 0;  ///< of the light, what came from bins of gloss at the end of long paths
    PictureError error;       ///< mean over the pictures
};

/// When pictures are done.
struct DrawRule {
    int samples = default_samples;       ///< at most so many draws a pixel
    double end = 0;                      ///< by seconds_now(); 0: never
    std::optional<double> target_error;  ///< squared, of draws and bins together
};

/// Pictures by the eye's own rays (renderer/gather), one camera after the other.
class EyePictures {
  public:
    EyePictures(const Scene& scene, const ShotOptions& options);

    /// The bins to end in, and when the pictures of so many cameras are done. Time is shared out evenly.
    void show(std::shared_ptr<const Snapshot> bins, const DrawRule& rule, std::size_t cameras);

    /// What drawing these cameras takes and errs by with the bins of a first trace: small pictures of few draws, scaled to
    /// the full size. And what the bins make the pictures err by. Errors are of the worst picture.
    struct Trial {
        Effort draws;
        double bins_error = 0;
    };
    Trial trial(std::shared_ptr<const Snapshot> bins, std::span<const Camera* const> cameras);

    /// What the camera sees; drawn when another one than before is asked for. Ctrl+C ends the drawing with what there is.
    const StokesPicture& of(const Camera& camera);

    GatherResult result() const;

  private:
    void draw(const StopAsked& stop, double end);

    const ShotOptions& options_;
    std::shared_ptr<const EyeScene> scene_;
    Gather gather_;
    unsigned threads_;
    DrawRule rule_;
    std::size_t cameras_left_ = 1;
    std::string camera_;  // of the picture
    StokesPicture picture_;
    int pictures_ = 0;
    GatherResult sums_;
};

}  // namespace brewster
