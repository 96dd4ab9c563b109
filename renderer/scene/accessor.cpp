#include "scene/accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace brewster {
namespace {

const unsigned char* view_bytes(const GltfFile& file, int view_index) {
    const GltfBufferView& view = file.buffer_views[static_cast<std::size_t>(view_index)];
    return file.buffers[static_cast<std::size_t>(view.buffer)].data() + view.byte_offset;
}

std::uint32_t unsigned_at(const unsigned char* bytes, int component_type) {
    std::uint32_t value = 0;  // glTF is little-endian, as is every machine this is built for
    std::memcpy(&value, bytes, component_bytes(component_type));
    return value;
}

// Null: zeros.
const unsigned char* element(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    if (accessor.sparse.count > 0) {
        std::size_t first = 0, last = accessor.sparse.count;  // the first substitute whose index is not below i
        while (first < last) {
            const std::size_t middle = first + (last - first) / 2;
            if (sparse_index(file, accessor.sparse, middle) < i) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        if (first < accessor.sparse.count && sparse_index(file, accessor.sparse, first) == i)
            return view_bytes(file, accessor.sparse.values_view) + accessor.sparse.values_offset +
                   first * element_bytes(accessor);
    }
    if (accessor.buffer_view < 0) return nullptr;
    return view_bytes(file, accessor.buffer_view) + accessor.byte_offset + i * element_stride(file, accessor);
}

template <class Number>
float fraction_of(const unsigned char* bytes, bool normalized) {
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    if (!normalized) return static_cast<float>(value);
    return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<Number>::max()), -1.0f);
}

float number_at(const unsigned char* bytes, int component_type, bool normalized) {
    switch (component_type) {
        case gltf_byte:
            return fraction_of<std::int8_t>(bytes, normalized);
        case gltf_unsigned_byte:
            return fraction_of<std::uint8_t>(bytes, normalized);
        case gltf_short:
            return fraction_of<std::int16_t>(bytes, normalized);
        case gltf_unsigned_short:
            return fraction_of<std::uint16_t>(bytes, normalized);
        default:
            return fraction_of<float>(bytes, false);
    }
}

}  // namespace

std::size_t component_bytes(int component_type) {
    switch (component_type) {
        case gltf_byte:
        case gltf_unsigned_byte:
            return 1;
        case gltf_short:
        case gltf_unsigned_short:
            return 2;
        case gltf_unsigned_int:
        case gltf_float:
            return 4;
        default:
            return 0;
    }
}

std::size_t element_bytes(const GltfAccessor& accessor) {
    return component_bytes(accessor.component_type) * static_cast<std::size_t>(accessor.components);
}

std::size_t element_stride(const GltfFile& file, const GltfAccessor& accessor) {
    const std::size_t stride = file.buffer_views[static_cast<std::size_t>(accessor.buffer_view)].byte_stride;
    return stride ? stride : element_bytes(accessor);
}

std::uint32_t read_index(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    const unsigned char* bytes = element(file, accessor, i);
    return bytes ? unsigned_at(bytes, accessor.component_type) : 0;
}

glm::vec4 read_vector(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    glm::vec4 vector(0.0f);
    const unsigned char* bytes = element(file, accessor, i);
    for (int k = 0; bytes && k < std::min(accessor.components, 4); ++k)
        vector[k] = number_at(bytes + static_cast<std::size_t>(k) * component_bytes(accessor.component_type),
                              accessor.component_type, accessor.normalized);
    return vector;
}

float read_float(const GltfFile& file, const GltfAccessor& accessor, std::size_t i, std::size_t k) {
    const unsigned char* bytes = element(file, accessor, i);
    return bytes ? number_at(bytes + 4 * k, gltf_float, false) : 0.0f;
}

std::uint32_t sparse_index(const GltfFile& file, const GltfSparse& sparse, std::size_t k) {
    return unsigned_at(
        view_bytes(file, sparse.indices_view) + sparse.indices_offset + k * component_bytes(sparse.indices_type),
        sparse.indices_type);
}

}  // namespace brewster
