#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "scene/passed_by.h"
#include "scene/rays.h"
#include "scene/triangle_hit.h"

namespace brewster {

/// Embree over the triangles of a scene, pinned to one instruction set, with shared edges watertight.
/// Constant once built, so any number of threads may ask.
class RayTree {
  public:
    RayTree(const Scene& scene, const PassedBy& passed_by);  ///< keeps references to both
    ~RayTree();

    /// The nearest triangle in front of each ray that it does not pass by, nor a hole there unless the ray meets holes.
    /// One ray alone and a ray in any company get the same bits.
    void trace(std::span<const Ray> rays, std::span<TriangleHit> hits) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
