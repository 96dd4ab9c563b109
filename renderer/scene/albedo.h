#pragma once
#include <glm/vec3.hpp>

#include "scene/rays.h"
#include "scene/scene.h"

namespace brewster {

/// What a point of a triangle multiplies its material's albedo and alpha by: its texture there times the colours of its
/// corners. `b1`, `b2`: barycentric coordinates of the second and third corner. 1 without either.
glm::vec4 tint_at(const Scene& scene, std::uint32_t triangle, float b1, float b2);

/// Albedo of the base where a ray met the scene, per band, [0, 1].
glm::vec3 albedo_at(const Scene& scene, const Hit& hit);

/// Whether the point belongs to a hole: its material is cut out by alpha, and alpha is below the cutoff there.
bool is_hole(const Scene& scene, std::uint32_t triangle, float b1, float b2);

}  // namespace brewster
