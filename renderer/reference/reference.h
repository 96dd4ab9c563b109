#pragma once
#include "reference/camera_tracer.h"
#include "reference/light_tracer.h"

namespace brewster {

/// A picture that never saw a bin: the camera tracer's paths and the light tracer's, disjoint classes that add up.
class Reference {
  public:
    /// Keeps references to scene and camera. `threads` >= 1.
    Reference(const Scene& scene, const Camera& camera, int width, int height, bool polarized, std::uint64_t seed,
              unsigned threads);

    /// So many more samples for each pixel, and photons where the light tracer has something to do: one a sample at
    /// first, after 16 samples as many as the variances of both advise. What comes out depends on the samples' sum alone.
    void add_samples(std::uint64_t count);

    std::uint64_t samples() const { return camera_tracer_.samples(); }  ///< per pixel
    std::uint64_t photons() const { return light_tracer_.photons(); }

    /// S0.R .. S3.B and the variance of each, V0.R .. V3.B, in cd/m2. Needs 1 sample.
    Image picture() const;

  private:
    void trace(std::uint64_t samples, double photons_a_sample);

    const Surroundings surroundings_;
    CameraTracer camera_tracer_;
    LightTracer light_tracer_;
    unsigned threads_;
    double photons_a_sample_ = 1;  // after the pilot
};

/// Mean of a Stokes component over all pixels, and its standard error from the variance channels.
struct PictureMean {
    double mean = 0, standard_error = 0;
};
PictureMean mean_of(const Image& picture, int component, int band);

}  // namespace brewster
