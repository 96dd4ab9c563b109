#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace brewster {

enum class LampKind { area, sun, point, spot };

/// A source of light. Power is what the engine emits: for a sun, its irradiance times its rectangle below.
struct Lamp {
    LampKind kind = LampKind::area;
    std::string name;
    glm::vec3 power{0.0f};  ///< lumen per band
    glm::vec3 intensity{
        0.0f};  ///< area: radiance (cd/m2); sun: irradiance across the beam (lux); point, spot: cd on axis
    glm::vec3 position{0.0f};                  ///< point, spot
    glm::vec3 direction{0.0f, 0.0f, -1.0f};    ///< sun, spot: unit, the way the light travels
    float cos_inner = 1.0f, cos_outer = 0.0f;  ///< spot cone
    float angular_radius = 0;                  ///< sun: of its disc, radians; 0: a parallel beam
    /// S1, S2, S3 over S0 of what leaves it. The x axis of light in direction d is `axis` less its part along d; where
    /// d runs along `axis`, `second_axis` takes its place.
    glm::vec3 polarization{0.0f};
    glm::vec3 axis{1.0f, 0.0f, 0.0f}, second_axis{0.0f, 1.0f, 0.0f};  ///< x and y of the lamp's node, unit
    std::uint32_t chart = 0;                                          ///< area: whose front side emits

    float mean_power() const { return (power.x + power.y + power.z) / 3.0f; }
};

/// Lumen per band. A spot: 2 pi I ((1 - cos inner) + (cos inner - cos outer)/3), from the falloff below.
glm::vec3 point_power(glm::vec3 intensity);
glm::vec3 spot_power(glm::vec3 intensity, float cos_inner, float cos_outer);

/// Where a sun's photons start: a rectangle across the beam, upstream of the scene, that covers the projection of its
/// bounds. Points are centre + s half_u + t half_v with s, t in [-1, 1].
struct SunRectangle {
    glm::vec3 centre{0.0f}, half_u{0.0f}, half_v{0.0f};
    float area = 0;  ///< m2
};

/// `low`, `high`: the bounds of the scene; `direction`: unit, the way the light travels, or the middle of a disc of that
/// angular radius (radians), from all of whose directions the rectangle covers the bounds.
SunRectangle sun_rectangle(glm::vec3 low, glm::vec3 high, glm::vec3 direction, float angular_radius = 0);

/// A unit vector across `axis`, from the coordinate axis it leans on least.
glm::vec3 across(glm::vec3 axis);

/// Of a sun's disc; 0: it has one direction.
float sine_of_radius(const Lamp& sun);

/// Densities per steradian of the directions that lamps send light in (start_direction.h), and directions from two
/// numbers in [0, 1).
float pdf_disc(const Lamp& sun, glm::vec3 direction);
/// Cosine-distributed about the normal of a right-handed unit frame: density cos / pi.
glm::vec3 sample_cosine(glm::vec3 axis_u, glm::vec3 axis_v, glm::vec3 normal, float x, float y);
float pdf_cosine(glm::vec3 normal, glm::vec3 direction);
/// Uniform over the sphere: density 1 / (4 pi).
glm::vec3 sample_sphere(float x, float y);
float pdf_sphere();
/// Proportional to the falloff of a spot, ((cos - cos outer) / (cos inner - cos outer))^2 between the cones, 1 inside
/// (KHR_lights_punctual).
float pdf_spot(const Lamp& spot, glm::vec3 direction);

}  // namespace brewster
