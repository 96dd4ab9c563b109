#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/gltf_builder.h"

namespace brewster {

/// A lit, seen quad: one mesh, material, camera, light, and a child node. Nothing is wrong with it.
GltfBuilder whole_file();

/// One fault in it.
struct Mutation {
    std::string name;
    std::function<void(nlohmann::json&)> change;
    std::string words;  ///< of the message
};

const std::vector<Mutation>& mutations();

}  // namespace brewster
