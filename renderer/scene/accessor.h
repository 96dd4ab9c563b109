#pragma once
#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/gltf_file.h"

namespace brewster {

/// Bytes of one number of an accessor's component type; 0 for an unknown type.
std::size_t component_bytes(int component_type);

/// Bytes from one element of an accessor to the next.
std::size_t element_stride(const GltfFile& file, const GltfAccessor& accessor);

inline constexpr int gltf_unsigned_byte = 5121, gltf_unsigned_short = 5123, gltf_unsigned_int = 5125, gltf_float = 5126;

/// Primitive mode of separate triangles.
inline constexpr int gltf_triangles = 4;

/// Element i of an accessor that `validate` has found to lie inside its bytes.
/// `read_index`: a scalar of any unsigned width. `read_position`: three floats.
std::uint32_t read_index(const GltfFile& file, const GltfAccessor& accessor, std::size_t i);
glm::vec3 read_position(const GltfFile& file, const GltfAccessor& accessor, std::size_t i);

}  // namespace brewster
