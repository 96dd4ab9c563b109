#pragma once
#include <cstdint>
#include <glm/vec4.hpp>

#include "scene/gltf_file.h"

namespace brewster {

inline constexpr int gltf_byte = 5120, gltf_unsigned_byte = 5121, gltf_short = 5122, gltf_unsigned_short = 5123,
                     gltf_unsigned_int = 5125, gltf_float = 5126;

/// Sampler constants (glTF 2.0, 5.26).
inline constexpr int gltf_nearest = 9728, gltf_linear = 9729, gltf_clamp = 33071, gltf_mirror = 33648,
                     gltf_repeat = 10497;

/// Primitive modes from lists of triangles on; those below are points and lines.
inline constexpr int gltf_triangles = 4, gltf_triangle_strip = 5, gltf_triangle_fan = 6;

/// Bytes of one number of an accessor's component type; 0 for an unknown type.
std::size_t component_bytes(int component_type);

/// Bytes of one element, and from one element to the next.
std::size_t element_bytes(const GltfAccessor& accessor);
std::size_t element_stride(const GltfFile& file, const GltfAccessor& accessor);

/// Element i of an accessor that `validate` has found to lie inside its bytes: its sparse substitute, else what its
/// bufferView holds, else zeros.
/// `read_index`: a scalar of any unsigned width.
std::uint32_t read_index(const GltfFile& file, const GltfAccessor& accessor, std::size_t i);
/// Up to four numbers, the rest 0. Normalized integers become fractions: c / 255, max(c / 127, -1), and so on
/// (glTF 2.0, 3.6.2.2 and "Animations", equations for normalized integers).
glm::vec4 read_vector(const GltfFile& file, const GltfAccessor& accessor, std::size_t i);
/// Number k of element i of an accessor of floats: a matrix has 16 of them.
float read_float(const GltfFile& file, const GltfAccessor& accessor, std::size_t i, std::size_t k);

/// Index k of the elements that a sparse accessor substitutes.
std::uint32_t sparse_index(const GltfFile& file, const GltfSparse& sparse, std::size_t k);

}  // namespace brewster
