#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/rays.h"
#include "scene/triangle_hit.h"

namespace brewster {

/// Embree over the triangles of a scene, pinned to one instruction set, with shared edges watertight.
/// Constant once built, so any number of threads may ask.
class RayTree {
  public:
    /// Keeps a reference to the scene. `planes`: a number for each triangle; triangles of one number are passed together.
    RayTree(const Scene& scene, std::vector<std::uint32_t> planes);
    ~RayTree();

    /// The nearest triangle in front of each ray that is not of its number in `planes`, nor a hole there unless the ray
    /// meets holes. One ray alone and a ray in any
    /// company get the same bits.
    void trace(std::span<const Ray> rays, std::span<const std::uint32_t> planes, std::span<TriangleHit> hits) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
