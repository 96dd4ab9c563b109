#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/texture.h"

namespace brewster {

/// Decodes the textures that materials name. A picture that is missing or broken is said once and left out; one that is
/// too large, or too many of them, is an Error.
class TextureReader {
  public:
    static constexpr int longest_side = 8192;
    static constexpr std::size_t most_texels = std::size_t{1} << 26;

    /// Keeps references to all of them.
    TextureReader(const GltfFile& file, const std::string& where, std::vector<std::string>& warnings)
        : file_(file), where_(where), warnings_(warnings) {}

    /// Texture of this index in the file; null where there is none to read. The pointer holds until the next call.
    const SurfaceTexture* read(int texture);

    /// The number in `textures` of one that `read` has found.
    std::uint32_t keep(int texture);

    std::vector<SurfaceTexture> take() { return std::move(kept_); }

  private:
    using Texels = std::shared_ptr<const std::vector<std::uint8_t>>;
    struct Picture {
        int width = 0, height = 0;
        Texels texels;  ///< null: missing or broken
    };

    const Picture& picture(int image);
    Picture decoded(std::size_t image);

    const GltfFile& file_;
    const std::string& where_;
    std::vector<std::string>& warnings_;
    std::map<int, Picture> pictures_;
    std::map<int, std::uint32_t> numbers_;
    std::vector<SurfaceTexture> kept_;
    SurfaceTexture last_;
    std::size_t texels_ = 0;
};

/// Texture coordinates after KHR_texture_transform: scaled, turned counter-clockwise, moved.
glm::vec2 transformed(const GltfTextureUse& use, glm::vec2 coordinates);

}  // namespace brewster
