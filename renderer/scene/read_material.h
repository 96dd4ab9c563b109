#pragma once
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/material.h"

namespace brewster {

std::string material_name(const GltfMaterial& material, std::size_t index);

/// The material's optics, complete; what the file asks for and nobody simulates adds a sentence to `warnings`.
Material read_material(const GltfMaterial& from, std::size_t index, std::vector<std::string>& warnings);

/// What a primitive without a material gets: Lambert 0.8.
Material default_material();

}  // namespace brewster
