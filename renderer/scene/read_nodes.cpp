#include "scene/read_nodes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace brewster {
namespace {

glm::dmat4 local_transform(const GltfNode& node) {
    glm::dmat4 transform(1.0);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i) transform[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return transform;
    }
    if (!node.rotation.empty())
        transform = glm::mat4_cast(
            glm::normalize(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])));
    if (!node.scale.empty())
        for (int k = 0; k < 3; ++k) transform[k] *= node.scale[static_cast<std::size_t>(k)];
    if (!node.translation.empty())
        transform[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    return transform;
}

std::vector<int> nodes_without_parent(const GltfFile& file) {
    std::vector<bool> is_child(file.nodes.size(), false);
    for (const GltfNode& node : file.nodes)
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < file.nodes.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

// Nodes below these roots, parents first.
std::vector<PlacedNode> nodes_below(const GltfFile& file, const std::vector<int>& roots) {
    std::vector<PlacedNode> nodes;
    for (const int root : roots) nodes.push_back({static_cast<std::size_t>(root), glm::dmat4(1.0)});
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const GltfNode& node = file.nodes[nodes[i].index];
        nodes[i].to_world = nodes[i].to_world * local_transform(node);
        for (const int child : node.children) nodes.push_back({static_cast<std::size_t>(child), nodes[i].to_world});
    }
    return nodes;
}

}  // namespace

std::vector<glm::dmat4> world_transforms(const GltfFile& file) {
    std::vector<glm::dmat4> transforms(file.nodes.size());
    for (const PlacedNode& node : nodes_below(file, nodes_without_parent(file))) transforms[node.index] = node.to_world;
    return transforms;
}

std::vector<PlacedNode> placed_nodes(const GltfFile& file) {
    if (file.scenes.empty()) return nodes_below(file, nodes_without_parent(file));
    return nodes_below(file, file.scenes[static_cast<std::size_t>(std::max(file.scene, 0))].nodes);
}

}  // namespace brewster
