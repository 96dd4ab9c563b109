#pragma once
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/material.h"

namespace brewster {

std::string material_name(const GltfMaterial& material, std::size_t index);

/// The material's optics as far as they are simulated; what is not adds a sentence to `warnings`.
/// A dielectric or conductor interface becomes the nearest Lambert surface: its base colour.
Material read_material(const GltfMaterial& from, std::size_t index, std::vector<std::string>& warnings);

/// What a primitive without a material gets: Lambert 0.8.
Material default_material();

}  // namespace brewster
