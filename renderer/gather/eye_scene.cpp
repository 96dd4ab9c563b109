#include "gather/eye_scene.h"

#include <algorithm>

#include "scene/needs.h"

namespace brewster {
namespace {

bool is_coloured(const Scene& scene) {
    return !scene.vertex_colors.empty() || std::any_of(scene.materials.begin(), scene.materials.end(),
                                                       [](const Material& m) { return m.texture != no_texture; });
}

bool has_polarized_lamps(const Scene& scene) {
    return std::any_of(scene.lamps.begin(), scene.lamps.end(),
                       [](const Lamp& lamp) { return lamp.polarization != glm::vec3(0.0f); });
}

bool ends_in_bins_anywhere(const Scene& scene) {
    return std::none_of(scene.materials.begin(), scene.materials.end(),
                        [](const Material& m) { return m.beyond_bins(); });
}

}  // namespace

EyeScene::EyeScene(const Scene& whole)
    : scene(whole),
      rays(whole),
      lamps(whole),
      materials(prepare_materials(whole.materials)),
      components(needs_of(whole).stokes > 1 || has_polarized_lamps(whole) ? 4 : 1),
      coloured(is_coloured(whole)),
      polarized_lamps(has_polarized_lamps(whole)),
      ends_anywhere(ends_in_bins_anywhere(whole)) {}

}  // namespace brewster
