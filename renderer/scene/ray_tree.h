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
    /// `planes`: a number for each triangle; triangles of one number are passed together.
    RayTree(const Scene& scene, std::vector<std::uint32_t> planes);
    ~RayTree();

    /// The nearest triangle in front of each ray, whatever it leaves. One ray alone and a ray in any company get the
    /// same bits.
    void trace(std::span<const Ray> rays, std::span<TriangleHit> hits) const;

    /// The nearest triangle that is not of this plane.
    TriangleHit trace_past(const Ray& ray, std::uint32_t plane) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
