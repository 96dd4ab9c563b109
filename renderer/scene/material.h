#pragma once
#include <glm/vec3.hpp>
#include <string>

namespace brewster {

/// A surface's optics, per band red, green, blue. So far: a Lambert base, and light of its own.
struct Material {
    std::string name;
    glm::vec3 albedo{0.8f};    ///< reflected over entered flux, [0, 1]
    glm::vec3 emission{0.0f};  ///< radiance that leaves the surface, cd/m2
    bool double_sided = false;

    bool emits() const { return emission.x > 0 || emission.y > 0 || emission.z > 0; }
};

}  // namespace brewster
