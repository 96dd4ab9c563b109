#pragma once
#include <vector>

#include "scene/material.h"

/// One material of every kind that light can meet.
namespace brewster::test_materials {

inline Material lambert() {
    Material material;
    material.name = "Lambert";
    material.albedo = {0.8f, 0.5f, 0.1f};
    return material;
}

inline Material over(InterfaceKind kind, glm::vec3 n, glm::vec3 k, Base base) {
    Material material;
    material.interface.kind = kind;
    material.interface.n = n;
    material.interface.k = k;
    material.base = base;
    material.albedo = base == Base::polarized_diffuse ? glm::vec3(0.9f, 0.5f, 0.2f) : glm::vec3(0.0f);
    return material;
}

inline Material dielectric(Base base, glm::vec3 n = glm::vec3(1.5f)) {
    return over(InterfaceKind::dielectric, n, glm::vec3(0.0f), base);
}

inline Material gold() {
    return over(InterfaceKind::conductor, {0.221f, 0.428f, 1.332f}, {3.215f, 2.460f, 1.869f}, Base::black);
}

inline Material beckmann(Material material, float slope) {
    material.interface.finish = Finish::beckmann;
    material.interface.slope = slope;
    return material;
}

/// Micrometres.
inline Material kirchhoff(Material material, float rms_height, float correlation_length) {
    material.interface.finish = Finish::kirchhoff;
    material.interface.slope = 2 * rms_height / correlation_length;
    material.interface.rms_height = rms_height;
    material.interface.correlation_length = correlation_length;
    return material;
}

inline Material named(Material material, const char* name) {
    material.name = name;
    return material;
}

inline Material pane() {
    Material material = dielectric(Base::transparent);
    material.thin = true;
    return material;
}

inline Material filter(FilterKind kind, float angle, glm::vec3 retardance = glm::vec3(0.0f)) {
    Material material;
    material.base = Base::transparent;
    material.albedo = glm::vec3(0.0f);
    material.thin = true;
    material.filter = {kind, angle, retardance};
    return material;
}

/// All of them; the names say what failed.
inline std::vector<Material> all() {
    const glm::vec3 dispersive{1.50f, 1.52f, 1.56f};
    return {lambert(),
            named(dielectric(Base::black, glm::vec3(10.0f)), "smooth black"),
            named(gold(), "gold mirror"),
            named(dielectric(Base::polarized_diffuse, dispersive), "smooth plastic"),
            named(beckmann(dielectric(Base::black, dispersive), 0.2f), "black gloss"),
            named(beckmann(gold(), 0.3f), "rough gold"),
            named(beckmann(dielectric(Base::polarized_diffuse), 0.5f), "rough plastic"),
            named(beckmann(dielectric(Base::polarized_diffuse, dispersive), 0.15f), "plastic"),
            named(kirchhoff(dielectric(Base::black), 0.08f, 1.5f), "Kirchhoff black"),
            named(kirchhoff(gold(), 0.03f, 0.5f), "Kirchhoff gold"),
            named(kirchhoff(dielectric(Base::polarized_diffuse), 0.1f, 1.5f), "Kirchhoff plastic"),
            named(dielectric(Base::transparent), "glass"),
            named(pane(), "pane"),
            named(filter(FilterKind::polarizer, 0.3f), "polarizer"),
            named(filter(FilterKind::retarder, 1.1f, {1.5f, 1.7f, 2.0f}), "retarder")};
}

}  // namespace brewster::test_materials
