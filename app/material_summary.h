#pragma once
#include <string>

#include "scene/scene.h"

namespace brewster {

std::string base_name(Base base);
std::string interface_name(InterfaceKind kind);
std::string finish_name(Finish finish);

/// Whether light that leaves the material can be polarized though what arrives is not (or change its polarization), and
/// why, in a clause.
struct Polarizes {
    bool yes = false;
    std::string why;
};
Polarizes polarizes(const Material& material);

/// What a material is made of, for people: "dielectric n 1.5, rough m 0.25, over a diffuse base of albedo 0.8 0.8 0.8".
std::string described(const Scene& scene, const Material& material);

}  // namespace brewster
