#include "scene/read_texture.h"

#include <cmath>
#include <span>

#include "base/error.h"
#include "image/decode.h"
#include "scene/accessor.h"

namespace brewster {
namespace {

Wrap wrap_of(int mode) {
    return mode == gltf_clamp ? Wrap::clamp : mode == gltf_mirror ? Wrap::mirror : Wrap::repeat;
}

std::span<const unsigned char> bytes_of(const GltfFile& file, const GltfImage& image) {
    if (image.buffer_view < 0) return image.bytes;
    const GltfBufferView& view = file.buffer_views[static_cast<std::size_t>(image.buffer_view)];
    return std::span(file.buffers[static_cast<std::size_t>(view.buffer)]).subspan(view.byte_offset, view.byte_length);
}

}  // namespace

TextureReader::Picture TextureReader::decoded(std::size_t index) {
    const GltfImage& image = file_.images[index];
    const std::string name =
        image.uri.empty() ? "the picture images[" + std::to_string(index) + "]" : "the picture \"" + image.uri + "\"";
    const std::span<const unsigned char> bytes = bytes_of(file_, image);
    if (bytes.empty()) {
        warnings_.push_back(name + " is missing; the colours beside it are used alone");
        return {};
    }
    const std::optional<EncodedSize> size = encoded_size(bytes);
    if (size && (size->width > longest_side || size->height > longest_side))
        throw Error(name + " has " + std::to_string(size->width) + " x " + std::to_string(size->height) + " pixels",
                    where_, "scale it to at most " + std::to_string(longest_side) + " a side");
    if (size) texels_ += size->texels();
    if (texels_ > most_texels)
        throw Error("its pictures have more than " + std::to_string(most_texels >> 20) + " million pixels together",
                    where_, "scale them down");
    std::optional<std::vector<std::uint8_t>> rgba = decode_rgba(bytes);
    if (!rgba) {
        warnings_.push_back(name + " is no PNG or JPEG that can be read; the colours beside it are used alone");
        return {};
    }
    return {size->width, size->height, std::make_shared<const std::vector<std::uint8_t>>(std::move(*rgba))};
}

const TextureReader::Picture& TextureReader::picture(int image) {
    const auto found = pictures_.find(image);
    if (found != pictures_.end()) return found->second;
    return pictures_.emplace(image, decoded(static_cast<std::size_t>(image))).first->second;
}

const SurfaceTexture* TextureReader::read(int texture) {
    if (texture < 0) return nullptr;
    const GltfTexture& from = file_.textures[static_cast<std::size_t>(texture)];
    if (from.source < 0) {
        warnings_.push_back("textures[" + std::to_string(texture) +
                            "] names no PNG or JPEG; the colours beside it are used alone");
        return nullptr;
    }
    const Picture& found = picture(from.source);
    if (!found.texels) return nullptr;
    const GltfSampler sampler =
        from.sampler < 0 ? GltfSampler{} : file_.samplers[static_cast<std::size_t>(from.sampler)];
    last_ = {found.width,
             found.height,
             found.texels,
             wrap_of(sampler.wrap_s),
             wrap_of(sampler.wrap_t),
             sampler.mag_filter == gltf_nearest};
    return &last_;
}

std::uint32_t TextureReader::keep(int texture) {
    const auto known = numbers_.find(texture);
    if (known != numbers_.end()) return known->second;
    const SurfaceTexture* found = read(texture);
    if (!found) return no_texture;
    kept_.push_back(*found);
    return numbers_[texture] = static_cast<std::uint32_t>(kept_.size() - 1);
}

// The extension's text turns the picture clockwise; v grows downwards, so its matrix is (c s; -s c).
glm::vec2 transformed(const GltfTextureUse& use, glm::vec2 coordinates) {
    const double u = use.scale[0] * static_cast<double>(coordinates.x),
                 v = use.scale[1] * static_cast<double>(coordinates.y);
    const double c = std::cos(use.rotation), s = std::sin(use.rotation);
    return {static_cast<float>(use.offset[0] + c * u + s * v), static_cast<float>(use.offset[1] - s * u + c * v)};
}

}  // namespace brewster
