#pragma once
#include <array>

#include "display/light_textures.h"
#include "image/stokes_picture.h"

namespace brewster {

/// A picture of both worlds that was made elsewhere, by rays of the eye or read from a file, on the graphics side.
class GatheredLight {
  public:
    /// Sends the picture; another size makes room anew. Needs a current context.
    void upload(const StokesPicture& picture);
    /// Empty (all black) before the first upload.
    LightTextures textures() const;

  private:
    std::array<Texture, plane_count> light_;
    Texture variance_s0_, variance_linear_, variance_s3_, variance_unpolarized_;
};

}  // namespace brewster
