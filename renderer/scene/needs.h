#pragma once
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// The least that light must carry to be exact in a scene, found by looking forward from its lamps: what can any light
/// become? A camera always counts as sensitive to polarization.
struct Needs {
    int stokes = 1;                    ///< components: 1 without anything that polarizes, 3, or 4 where S3 can arise
    int bands = 3;                     ///< 1 where all light has one colour and no surface changes it
    bool polarized_lamps = false;      ///< some lamp's own light is polarized and something can tell
    glm::vec3 colour{1.0f};            ///< with one band: the light's, of mean 1
    std::vector<std::string> reasons;  ///< a sentence for each choice, naming the surfaces that decide
};

Needs needs_of(const Scene& scene);

}  // namespace brewster
