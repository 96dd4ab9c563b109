#pragma once
#include <cstdint>
#include <vector>

#include "display/gl_object.h"
#include "display/program.h"
#include "scene/scene.h"

namespace brewster {

/// The scene's textures on the graphics side, in linear light. They are not made smaller for distance: a picture is the
/// mean of draws that look all over its pixels.
class AlbedoTextures {
  public:
    /// Throws Error when one is larger than the driver allows.
    explicit AlbedoTextures(const Scene& scene);

    /// Binds a texture of the scene; no_texture: white.
    void bind(const Program& program, const char* uniform, int unit, std::uint32_t texture) const;

  private:
    std::vector<Texture> textures_;
    Texture white_;
};

}  // namespace brewster
