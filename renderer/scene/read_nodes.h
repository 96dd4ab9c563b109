#pragma once
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

#include "scene/gltf_file.h"

namespace brewster {

/// A node of a validated file and its transform to the world, in metres.
struct PlacedNode {
    std::size_t index;
    glm::dmat4 to_world;
};

/// The nodes of the file's default scene (the first if it names none), or of all if it has no scene, parents first.
std::vector<PlacedNode> placed_nodes(const GltfFile& file);

/// The transforms of all nodes by index: joints may stand outside the scene.
std::vector<glm::dmat4> world_transforms(const GltfFile& file);

}  // namespace brewster
