#pragma once
#include <string>

#include "scene/gltf_file.h"

namespace brewster {

/// Checks everything that reading relies on: each index, count, stride, offset and type, the values that physics needs
/// finite or in range, that nodes form a forest, and that no extension is required which is not simulated.
/// Throws an Error that names the first fault; `where` stands in it.
void validate(const GltfFile& file, const std::string& where);

}  // namespace brewster
