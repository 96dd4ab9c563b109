#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "scene/scene.h"
#include "scene/triangle_hit.h"

namespace brewster {

struct LandingTable;

/// Nothing in the plane of the triangle that a ray leaves can be hit. Of a curved patch only the triangle itself is
/// passed by, so that a concave one sees itself, and triangles that share a corner with it where they would be met from
/// behind: rounding puts a start below its facet's edge.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, 1.0f};  ///< unit
    std::uint32_t leaving = no_triangle;    ///< the triangle the ray starts on (Hit::triangle): see above
    bool meets_holes = false;               ///< stops at what is cut out by alpha, too, and says so; else passes it
};

/// Where a ray meets the scene first. `position` lies on the triangle's plane, pulled inside its edges by 1e-6 of the
/// chart's size, so that no next ray starts outside.
struct Hit {
    std::uint32_t triangle = no_triangle;  ///< no_triangle: the ray left the scene
    std::uint32_t chart = no_chart;        ///< of the side that was hit; no_chart on a back that absorbs
    float distance = 0;
    glm::vec3 position{0.0f};
    bool hole = false;               ///< of a ray that meets holes: light passes here
    std::uint32_t u = 0, v = 0;      ///< fixed-point chart coordinates, 24 bits
    float b1 = 0, b2 = 0;            ///< barycentric coordinates of the triangle's second and third corner
    glm::vec3 normal{0.0f};          ///< of the triangle, unit, on the side that was hit
    glm::vec3 shading_normal{0.0f};  ///< interpolated from the corners, unit, on the same side; flat meshes: `normal`

    bool escaped() const { return triangle == no_triangle; }
};

/// Answers rays against a constant scene; any number of threads may ask at once. The answers do not depend on how rays
/// are grouped into calls.
class Rays {
  public:
    explicit Rays(const Scene& scene);  ///< keeps a reference to the scene
    ~Rays();
    Rays(const Rays&) = delete;
    Rays& operator=(const Rays&) = delete;

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;

    /// The same in parts, for whoever lands rays in lanes: the triangles that rays meet first (none: they left the scene),
    /// and what a landing is worked out from (landing.h). Where `hits` lies on a hole or on a back that absorbs, the
    /// caller sees.
    void meet(std::span<const Ray> rays, std::span<TriangleHit> hits) const;
    const LandingTable& landing_table() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace brewster
