#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>

#include "display/light_textures.h"
#include "image/stokes_picture.h"

namespace brewster {

/// A picture of both worlds that was made elsewhere, by rays of the eye or read from a file, on the graphics side: what
/// is shown, and what is on its way and takes its place when it is complete.
class GatheredLight {
  public:
    /// Sends the picture; another size makes room anew. Needs a current context.
    void upload(const StokesPicture& picture);

    /// The same in parts: after `begin`, `advance` with the same picture again and again, each time at most so many bytes
    /// (whole rows, at least one), until it says that the picture is shown from now on.
    void begin() { rows_done_ = 0; }
    bool advance(const StokesPicture& picture, std::size_t bytes);

    /// Empty (all black) before the first upload.
    LightTextures textures() const;

  private:
    enum Part { variance_s0 = plane_count, variance_linear, variance_s3, variance_unpolarized, part_count };
    struct Side {
        std::array<Texture, part_count> parts;
        std::array<glm::ivec2, part_count> sizes{};
    };
    static void make_room(Side& side, std::size_t part, glm::ivec2 size);

    std::array<Side, 2> sides_;
    std::size_t shown_ = 0;
    int rows_done_ = 0;  ///< of all parts, one after the other
};

}  // namespace brewster
