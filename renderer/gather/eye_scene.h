#pragma once
#include <vector>

#include "scene/lamp_light.h"
#include "scene/prepared_material.h"
#include "scene/rays.h"
#include "scene/scene.h"

namespace brewster {

/// A scene made ready for rays from the eye. Made once for a scene, used by any number of pictures and threads.
struct EyeScene {
    explicit EyeScene(const Scene& whole);  ///< keeps a reference to the scene

    const Scene& scene;
    const Rays rays;
    const LampLights lamps;
    const std::vector<PreparedMaterial> materials;
    const int components;        ///< of the Stokes vectors that a camera can see: 1, or all 4
    const bool coloured;         ///< some base has another albedo from place to place
    const bool polarized_lamps;  ///< some lamp's own light is polarized
    const bool ends_anywhere;    ///< the bins tell all light everywhere: no mirror, no glass, no very sharp gloss
};

}  // namespace brewster
