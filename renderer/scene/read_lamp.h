#pragma once
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/scene.h"

namespace brewster {

/// A sun, point or spot as placed by its node (light travels along the node's -z); a sun's power is set once the
/// scene's bounds are known. What is not simulated adds a sentence to `warnings`.
Lamp read_lamp(const GltfLight& from, const std::string& name, const glm::dmat4& to_scene,
               std::vector<std::string>& warnings);

/// Lumen per band that a sun sends into the scene's bounds.
glm::vec3 sun_power(const Scene& scene, const Lamp& sun);

/// Replaces the area lamps by one for each chart whose material emits.
void renew_area_lamps(Scene& scene);

/// Adds the area lamps, and sets the suns' powers from the bounds.
void complete_lamps(Scene& scene);

}  // namespace brewster
