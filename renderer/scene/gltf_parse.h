#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "scene/gltf_file.h"

namespace brewster {

/// Reads the bytes of a .gltf or .glb file. Buffers are data URIs, the binary chunk, or files below `folder`; an empty
/// folder allows no files. Nothing in the result is checked yet but its types (see validate.h). Throws Error;
/// `where` stands in it.
GltfFile parse_gltf(std::span<const unsigned char> bytes, const std::filesystem::path& folder,
                    const std::string& where);

}  // namespace brewster
