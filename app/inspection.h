#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "base/units.h"
#include "image/stokes_picture.h"
#include "scene/rays.h"
#include "scene/scene.h"

namespace brewster {

/// Light that arrives at the camera through a pixel or a rectangle of pixels: Stokes vectors in the camera's frame per
/// band, cd/m2, with standard errors.
struct SeenLight {
    std::array<std::array<double, 4>, band_count> stokes{}, error{};
    std::array<double, 4> mean() const;  ///< over the bands
    std::array<double, 4> mean_error() const;

    double dolp() const;          ///< of the mean over the bands, in [0, 1]
    double docp() const;          ///< signed: right positive
    double aolp_degrees() const;  ///< in (-90, 90]
    double luminance() const;     ///< Rec. 709 weights
    /// What DoLP would be if there were only noise: it cannot be told from none below.
    double dolp_floor() const;
    /// Share of the light that an ideal polarizer at this angle lets through.
    double passed(double degrees) const;
};

/// The mean over pixels [low, high) of a picture, clamped to it; its error as if pixels were independent.
SeenLight seen_light(const StokesPicture& picture, glm::ivec2 low, glm::ivec2 high, bool polarization);

/// A place on a surface that is looked at.
struct SeenSurface {
    std::uint32_t chart = 0, material = 0;
    glm::vec3 position{0.0f};
    glm::vec2 unit_coordinates{0.0f};
    double incidence_degrees = 0;            ///< between the line of sight and the normal
    std::optional<double> brewster_degrees;  ///< of a dielectric, from the mean of n
};

/// Where a ray from the eye meets a surface that it can see.

std::optional<SeenSurface> seen_surface(const Scene& scene, const Rays& rays, glm::vec3 eye, glm::vec3 direction);

/// Brewster's angle of a material in degrees: of clear interfaces only.
std::optional<double> brewster_angle(const Material& material);

}  // namespace brewster
