#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace brewster {

enum class LampKind { area, sun, point, spot };

/// A source of light. Power is what the engine emits: for a sun, its irradiance times the projected bounds of the scene.
struct Lamp {
    LampKind kind = LampKind::area;
    std::string name;
    glm::vec3 power{0.0f};      ///< lumen per band
    glm::vec3 intensity{0.0f};  ///< area: radiance (cd/m2); sun: irradiance across the beam (lux); point, spot: cd on axis
    glm::vec3 position{0.0f};   ///< point, spot
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< sun, spot: unit, the way the light travels
    float cos_inner = 1.0f, cos_outer = 0.0f;  ///< spot cone
    std::uint32_t chart = 0;                   ///< area: whose front side emits

    float mean_power() const { return (power.x + power.y + power.z) / 3.0f; }
};

}  // namespace brewster
