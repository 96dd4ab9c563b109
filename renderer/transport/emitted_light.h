#pragma once
#include "optics/axis_across.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "scene/vectors.h"
#include "transport/emission.h"
#include "transport/path.h"

namespace brewster {

/// What a lamp's light is over its power, and the node's axes that its frame follows (lamp.h).
template <class Real>
struct LampPolarization {
    Vector<Real> stokes, axis, second_axis;
};

inline LampPolarization<float> polarization_of(const Scene& scene, std::uint32_t lamp) {
    const Lamp& of = scene.lamps[lamp];
    return {float_vector(of.polarization), float_vector(of.axis), float_vector(of.second_axis)};
}
inline LampPolarization<FloatLanes> polarization_of(const Scene& scene, WordLanes lamp) {
    std::array<std::uint32_t, lane_count> lamps;
    store(lamp, lamps.data());
    std::array<std::array<float, lane_count>, 9> numbers;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const Lamp& of = scene.lamps[lamps[lane]];
        for (int a = 0; a < 3; ++a) {
            const auto at = static_cast<std::size_t>(a);
            numbers[at][lane] = of.polarization[a];
            numbers[3 + at][lane] = of.axis[a];
            numbers[6 + at][lane] = of.second_axis[a];
        }
    }
    const auto vector = [&](std::size_t at) {
        return Vector<FloatLanes>{load<FloatLanes>(numbers[at].data()), load<FloatLanes>(numbers[at + 1].data()),
                                  load<FloatLanes>(numbers[at + 2].data())};
    };
    return {vector(0), vector(3), vector(6)};
}

/// The light of a photon as it leaves its lamp. With one band its weight is the scale that a guide gives it; polarized
/// lamps have their frame along their node's axes (lamp.h). The unpolarized world forgets the lamp's state, too.
template <int components, int bands, class Real>
PhotonLight<Real, components, bands> emitted_light(const Scene& scene, const PhotonEmission& emission,
                                                   const EmittedPhoton<Real>& emitted) {
    const Vector<Real>& direction = emitted.start.direction;
    PhotonLight<Real, components, bands> light;
    LampPolarization<Real> state{{Real(0), Real(0), Real(0)}, {}, {}};
    light.axis = axis_across(direction, direction);  // any will do
    if (emission.polarized()) {
        state = polarization_of(scene, emitted.lamp);
        const auto polarized = state.stokes.x != 0 || state.stokes.y != 0 || state.stokes.z != 0;
        for (const Vector<Real>& axis : {state.second_axis, state.axis}) {
            const Vector<Real> across = add_scaled(-dot(axis, direction), direction, axis);
            const auto oblique = polarized && !(dot(across, across) < constant<Real>(1e-6));
            light.axis = select(oblique, normalized(across), light.axis);
        }
    }
    for (std::size_t b = 0; b < bands; ++b) {
        const Real weight = bands == 1 ? emitted.scale : emitted.weight[b];
        light.polarized[b] =
            stokes_of<components>(weight, weight * state.stokes.x, weight * state.stokes.y, weight * state.stokes.z);
        if constexpr (components > 1) light.unpolarized[b] = weight;
    }
    return light;
}

/// The ray of a photon at its start, which stops at holes, too.
inline Ray first_ray(const EmittedPhoton<float>& emitted) {
    return {glm_vector(emitted.start.position), glm_vector(emitted.start.direction), emitted.start.leaving, true};
}

}  // namespace brewster
