#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/word_lanes.h"
#include "optics/vector.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "scene/triangle_hit.h"

namespace brewster {

/// A flat triangle, or two that make up a parallelogram: the corner plus u edge_u plus v edge_v. What lies beyond its
/// edges by as much as hits are pulled inside counts, so that no light gets out between two walls.
struct Wall {
    Vector<float> corner, normal;
    Vector<float> along_u, along_v;                                    ///< u = along_u . (point - corner), likewise v
    float low_u = 0, low_v = 0, high_u = 1, high_v = 1, high_sum = 1;  ///< bounds of u, v, u + v
    std::uint32_t plane = 0;                                           ///< of PassedBy
    double area = 0;
};

/// The triangles of a wall: that of the corner, and (parallelograms) the other. Turned: how many places the corner
/// opposite to the shared edge stands behind the triangle's first.
struct WallTriangles {
    std::array<std::uint32_t, 2> triangle{}, turned{};
};

/// The large flat surfaces of a scene, asked one by one: of few walls that is much faster than a tree. Every ray is
/// answered by itself, whatever its company.
class Walls {
  public:
    /// Chooses what is asked one by one; all other triangles are for the tree. That is a function of the scene alone.
    /// `planes`: of the triangles.
    Walls(const Scene& scene, const std::vector<std::uint32_t>& planes);

    const std::vector<std::uint32_t>& others() const { return others_; }  ///< triangles that are in no wall

    /// The nearest wall in front of each ray but those in the plane it leaves. `planes_left`: the plane of each ray's
    /// triangle, or what is no wall's plane.
    void trace(std::span<const Ray> rays, const std::uint32_t* planes_left, TriangleHit* hits) const;

    std::size_t count() const { return walls_.size(); }

  private:
    void add(const Wall& wall, const WallTriangles& triangles);

    std::vector<Wall> walls_;
    std::vector<std::uint32_t> triangle_, turned_;  // two for each wall
    std::vector<std::uint32_t> others_;
};

}  // namespace brewster
