#pragma once
#include <vector>

#include "gather/eye_scene.h"
#include "gather/lane_groups.h"
#include "gather/shade.h"

namespace brewster {

/// What lamps send to the entries of a level: a point on one of them for each, and a shadow ray to it. One per thread.
class LampRays {
  public:
    /// Adds it to the level's light. `vertex`: how many surfaces the draws have met before. Scenes with lamps only.
    template <int components>
    void light(const EyeScene& scene, const BatchNumbers& numbers, std::uint32_t vertex, Level& level);

  private:
    bool sample(const EyeScene& scene, const Level& level, std::uint32_t i);
    void take_none(std::uint32_t i);
    bool reaches(const EyeScene& scene, const Ray& ray, const TriangleHit& hit, std::uint32_t i) const;

    LampSamples lamps_;
    std::array<float, most_rays> u_, v_;  // of the points
    std::vector<Ray> rays_;
    std::vector<TriangleHit> hits_;
    std::vector<std::uint32_t> shadowed_;  // whose ray each is
};

}  // namespace brewster
