#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/passed_by.h"
#include "scene/rays.h"
#include "scene/triangle_hit.h"

namespace brewster {

/// Embree over some triangles of a scene, pinned to one instruction set, with shared edges watertight.
/// Constant once built, so any number of threads may ask.
class RayTree {
  public:
    /// Keeps references to the scene and the rule.
    RayTree(const Scene& scene, const PassedBy& passed_by, const std::vector<std::uint32_t>& triangles);
    ~RayTree();

    /// Replaces each hit by the nearest triangle of the tree, where one is in front of it that the ray does not pass by,
    /// nor a hole there unless the ray meets holes. A ray in any company gets the same bits.
    void improve(std::span<const Ray> rays, std::span<TriangleHit> hits) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
