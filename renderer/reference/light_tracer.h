#pragma once
#include "reference/camera_tracer.h"
#include "reference/light_path.h"

namespace brewster {

/// Paths from the lamps: every vertex is connected with the camera and splatted; nothing is binned. The other half of
/// the reference: it owns what a camera tracer cannot find.
/// The result depends on settings and number of photons alone.
class LightTracer {
  public:
    /// Keeps references to surroundings and camera.
    LightTracer(const Surroundings& surroundings, const Camera& camera, int width, int height,
                const TracerSettings& settings);

    /// False if no path of the classes exists, as far as materials tell: then there is nothing to trace.
    bool any() const { return any_; }

    /// Follows `count` more photons on so many threads.
    void add_photons(std::uint64_t count, unsigned threads);

    std::uint64_t photons() const { return photons_; }
    const StokesSums& sums() const { return sums_; }  ///< of all photons; a pixel's mean is over photons()

  private:
    struct Splat {
        std::size_t pixel;
        PixelStokes light;
    };
    template <int components>
    void follow(std::uint64_t index, std::vector<Splat>& splats) const;
    template <int components>
    void connect(const Photon<components>& photon, const LightPathClass& path_class, const Vertex& vertex,
                 std::vector<Splat>& splats) const;

    const Surroundings& surroundings_;
    const Camera& camera_;
    TracerSettings settings_;
    PhotonSource source_;
    StokesSums sums_;
    bool any_ = false;
    double picture_height_;  // of the image plane at distance 1
    std::uint64_t photons_ = 0;
};

}  // namespace brewster
