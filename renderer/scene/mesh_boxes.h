#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/rays.h"
#include "scene/scene.h"
#include "scene/triangle_hit.h"

namespace brewster {

/// Boxes around meshes, a little too large: rays that cross none of them need not ask for a mesh.
class MeshBoxes {
  public:
    /// Of the given triangles, one box a mesh as long as these are few.
    MeshBoxes(const Scene& scene, const std::vector<std::uint32_t>& triangles);

    /// The places of the rays that enter a box before their hit, ascending; `places` has room for all.
    std::span<const std::uint32_t> crossed_by(std::span<const Ray> rays, std::span<const TriangleHit> hits,
                                              std::span<std::uint32_t> places) const;

  private:
    struct Box {
        glm::vec3 low, high;
    };
    std::vector<Box> boxes_;
};

}  // namespace brewster
