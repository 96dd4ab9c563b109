#include "scene/material.h"

namespace brewster {

glm::vec3 normal_reflectance(const Interface& interface) {
    if (!interface.present()) return glm::vec3(0.0f);
    const glm::vec3 below = interface.n - 1.0f, above = interface.n + 1.0f, absorption = interface.k * interface.k;
    return (below * below + absorption) / (above * above + absorption);
}

}  // namespace brewster
