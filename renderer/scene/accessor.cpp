#include "scene/accessor.h"

#include <cstring>

namespace brewster {
namespace {

const unsigned char* element(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    const GltfBufferView& view = file.buffer_views[static_cast<std::size_t>(accessor.buffer_view)];
    return file.buffers[static_cast<std::size_t>(view.buffer)].data() + view.byte_offset + accessor.byte_offset +
           i * element_stride(file, accessor);
}

}  // namespace

std::size_t component_bytes(int component_type) {
    switch (component_type) {
        case 5120:
        case gltf_unsigned_byte:
            return 1;
        case 5122:
        case gltf_unsigned_short:
            return 2;
        case gltf_unsigned_int:
        case gltf_float:
            return 4;
        default:
            return 0;
    }
}

std::size_t element_stride(const GltfFile& file, const GltfAccessor& accessor) {
    const std::size_t stride = file.buffer_views[static_cast<std::size_t>(accessor.buffer_view)].byte_stride;
    return stride ? stride : component_bytes(accessor.component_type) * static_cast<std::size_t>(accessor.components);
}

std::uint32_t read_index(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    std::uint32_t index = 0;  // glTF is little-endian, as is every machine this is built for
    std::memcpy(&index, element(file, accessor, i), component_bytes(accessor.component_type));
    return index;
}

glm::vec3 read_position(const GltfFile& file, const GltfAccessor& accessor, std::size_t i) {
    float xyz[3];
    std::memcpy(xyz, element(file, accessor, i), sizeof xyz);
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace brewster
