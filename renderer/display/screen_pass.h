#pragma once
#include <map>
#include <tuple>

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

    /// Fills the screen, stretched where the sizes differ. `over`: what is there stays where the light has no draws.
    void show(const Screen& screen, const LightTextures& light, const Rendition& rendition, bool over = false) const;

  private:
    /// The program that shows this map, behind an analyzer or not, of a picture that is stretched or not.
    const Program& program(Map map, bool analyzed, bool stretched) const;

    mutable std::map<std::tuple<Map, bool, bool>, Program> programs_;  ///< made when first used
    VertexArray no_vertices_;
    Texture black_;
};

}  // namespace brewster
