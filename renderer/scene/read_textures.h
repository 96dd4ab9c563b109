#pragma once
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/material.h"
#include "scene/read_texture.h"

namespace brewster {

/// The material with the means of those textures in its factors that are not simulated place by place: metal and
/// roughness, emission, and the base colour of metals and of what is transparent. A sentence for each.
GltfMaterial with_texture_means(GltfMaterial material, const std::string& subject, TextureReader& textures,
                                std::vector<std::string>& warnings);

/// Gives the material that was read from `from` its base colour's texture, where it has a base to colour or is cut out
/// by alpha.
void set_texture(Material& material, const GltfMaterial& from, TextureReader& textures);

}  // namespace brewster
