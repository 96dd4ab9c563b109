#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "display/light_textures.h"
#include "image/stokes_picture.h"

namespace brewster {

/// A picture of both worlds that was made elsewhere, by rays of the eye or read from a file, on the graphics side. It may
/// come part by part: pixels that have not come are no draws (the alpha of LightTextures). Needs a current context.
class GatheredLight {
    enum Part { variance_s0 = plane_count, variance_linear, variance_s3, variance_unpolarized, part_count };

  public:
    static constexpr std::size_t pixel_bytes = part_count * sizeof(glm::vec4);  ///< that are sent

    /// Makes room for a picture of which nothing has come yet, in steps of a few milliseconds: true once it is there.
    bool make_room(int width, int height);
    /// Nothing has come again: the next picture makes room anew.
    void clear() { made_ = 0; }
    /// Puts a part there, its upper left pixel counted from the picture's; it must lie inside.
    void put(const StokesPicture& part, int left, int top);
    /// All of this for a whole picture.
    void upload(const StokesPicture& picture);

    /// Empty (all black) before the first picture.
    LightTextures textures() const;

  private:
    std::array<Texture, part_count> parts_;
    std::array<glm::ivec2, part_count> sizes_{};
    glm::ivec2 size_{0};
    std::size_t made_ = 0;  ///< parts that there is room for
};

}  // namespace brewster
