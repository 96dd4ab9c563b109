#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// Which triangles cannot be hit by a ray that leaves a triangle (see Ray). Refers to the scene.
class PassedBy {
  public:
    explicit PassedBy(const Scene& scene);

    /// `leaving`: the triangle that the ray starts on, or no_triangle.
    bool operator()(std::uint32_t triangle, std::uint32_t leaving, glm::vec3 direction) const {
        if (leaving == no_triangle) return false;
        if (triangle == leaving) return true;
        if (planes_[leaving] != curved) return planes_[triangle] == planes_[leaving];
        return is_neighbour_from_behind(triangle, leaving, direction);
    }

    /// The planes of the triangles; patches have none.
    const std::vector<std::uint32_t>& planes() const { return planes_; }
    std::uint32_t plane_left(std::uint32_t leaving) const { return leaving == no_triangle ? curved : planes_[leaving]; }

  private:
    static constexpr std::uint32_t curved = 0xffffffffu;

    bool is_neighbour_from_behind(std::uint32_t triangle, std::uint32_t leaving, glm::vec3 direction) const;

    const Scene& scene_;
    std::vector<std::uint32_t> planes_;  // of triangles; patches are `curved`
};

}  // namespace brewster
