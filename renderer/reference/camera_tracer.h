#pragma once
#include "reference/path_class.h"
#include "reference/stokes_sums.h"
#include "reference/surroundings.h"

namespace brewster {

/// What either tracer renders and how.
struct TracerSettings {
    bool polarized = true;    ///< false: every event uses the unpolarized reflectance and forgets the state
    PathClasses classes = 0;  ///< others are left out
    std::uint64_t seed = 1;
};

/// Paths from the camera: lamps sampled at every vertex and met by chance, joined by multiple importance sampling
/// (Veach 1997, power heuristic), lobe by lobe; Stokes vectors by Mueller matrices in light order (theory 3.9).
/// The result depends on settings and number of samples alone.
class CameraTracer {
  public:
    /// Keeps references to surroundings and camera.
    CameraTracer(const Surroundings& surroundings, const Camera& camera, int width, int height,
                 const TracerSettings& settings);

    /// Follows `count` more paths through each pixel (a box filter) on so many threads.
    void add_samples(std::uint64_t count, unsigned threads);

    std::uint64_t samples() const { return samples_; }  ///< per pixel
    const StokesSums& sums() const { return sums_; }

    /// What one sample brings.
    PixelStokes sample(int column, int row, std::uint64_t index) const;

  private:
    template <int components>
    PixelStokes follow(int column, int row, std::uint64_t index) const;

    const Surroundings& surroundings_;
    const Camera& camera_;
    TracerSettings settings_;
    StokesSums sums_;
    std::uint64_t samples_ = 0;
};

}  // namespace brewster
