#pragma once
#include "display/light_textures.h"
#include "display/program.h"
#include "display/rendition.h"
#include "display/screen.h"

namespace brewster {

/// Shows linear light on a screen: the one consumer of draws of the bins and of gathered pictures. Analyzer, map, world,
/// exposure and palette act here.
class ScreenPass {
  public:
    ScreenPass();

    /// Fills the screen, stretched where the sizes differ.
    void show(const Screen& screen, const LightTextures& light, const Rendition& rendition) const;

  private:
    Program program_;
    VertexArray no_vertices_;
    Texture black_;
};

}  // namespace brewster
