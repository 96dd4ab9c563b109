#pragma once
#include "optics/axis_across.h"
#include "scene/scene.h"
#include "scene/vectors.h"
#include "transport/emission.h"
#include "transport/path.h"

namespace brewster {

/// The light of a photon as it leaves its lamp. With one band its weight is the scale that a guide gives it; polarized
/// lamps have their frame along their node's axes (lamp.h). The unpolarized world forgets the lamp's state, too.
template <int components, int bands>
PhotonLight<float, components, bands> emitted_light(const Scene& scene, const EmittedPhoton& emitted) {
    const Lamp& lamp = scene.lamps[emitted.lamp];
    const Vector<float> direction = float_vector(emitted.ray.direction);
    PhotonLight<float, components, bands> light;
    for (int band = 0; band < bands; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const float weight = bands == 1 ? emitted.scale : emitted.weight[band];
        light.polarized[b] = stokes_of<components>(weight, weight * lamp.polarization.x, weight * lamp.polarization.y,
                                                   weight * lamp.polarization.z);
        if constexpr (components > 1) light.unpolarized[b] = weight;
    }
    if (lamp.polarization == glm::vec3(0.0f)) {
        light.axis = axis_across(direction, direction);  // any will do
        return light;
    }
    for (const glm::vec3& of_node : {lamp.axis, lamp.second_axis}) {
        const Vector<float> axis = float_vector(of_node);
        const Vector<float> across = add_scaled(-dot(axis, direction), direction, axis);
        if (dot(across, across) < 1e-6f) continue;
        light.axis = normalized(across);
        break;
    }
    return light;
}

}  // namespace brewster
