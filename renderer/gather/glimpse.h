#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "gather/eye_tracer.h"
#include "image/stokes_picture.h"

namespace brewster {

/// Light of surfaces that bins cannot show, and which chart each pixel's ray has met first; row 0 on top.
struct GlimpsePicture {
    int width = 0, height = 0;
    std::vector<std::uint32_t> chart;  ///< no_chart where bins can show what is there, or nothing is
    std::array<std::vector<glm::vec3>, plane_count> light;  ///< cd/m2, by plane, then by pixel
    std::size_t followed = 0;                               ///< rays whose light was asked for
};

/// One ray a pixel for what bins cannot show (Material::beyond_bins), at once: for the frames of a moving camera, beside a picture of the bins.
/// The same view gives the same bits, whatever the threads.
class Glimpse {
  public:
    explicit Glimpse(std::shared_ptr<const Scene> scene);

    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    bool any() const { return any_; }  ///< some chart is beyond bins

    /// `bins`: of this scene.
    GlimpsePicture see(const Snapshot& bins, const Camera& camera, int width, int height, unsigned threads);

  private:
    void see_row(EyeTracer& tracer, const Snapshot& bins, const Camera& camera, int row, GlimpsePicture& picture) const;

    std::shared_ptr<const Scene> scene_;
    EyeScene eye_;
    std::vector<bool> beyond_;  // per chart
    bool any_ = false;
    std::vector<std::unique_ptr<EyeTracer>> tracers_;
};

}  // namespace brewster
