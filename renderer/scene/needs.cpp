#include "scene/needs.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

namespace brewster {
namespace {

bool polarizes(const Material& material) {
    return material.interface.present() || material.filter.kind != FilterKind::none;
}

// Turns linear polarization at 45 degrees into circular: metals, total reflection inside bodies, retarders.
bool retards(const Material& material) {
    return material.interface.kind == InterfaceKind::conductor || material.filter.kind == FilterKind::retarder ||
           (material.base == Base::transparent && material.interface.present() && !material.thin);
}

bool grey(glm::vec3 value) {
    constexpr float equal = 1e-6f;
    const float most = std::max({value.x, value.y, value.z}), least = std::min({value.x, value.y, value.z});
    return most - least <= equal * std::abs(most);
}

bool grey(const Material& material) {
    const bool even_gloss = material.interface.finish != Finish::kirchhoff;  // a wave's roughness depends on its length
    return grey(material.albedo) && grey(material.interface.n) && grey(material.interface.k) && even_gloss &&
           grey(material.filter.retardance) && material.texture == no_texture;
}

std::string quoted(const Material& material) {
    return "\"" + material.name + "\"";
}

// The materials that some surface has, in their order.
std::vector<const Material*> used_materials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Chart& chart : scene.charts) used[chart.material] = true;
    std::vector<const Material*> materials;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) materials.push_back(&scene.materials[i]);
    return materials;
}

void find_stokes(const Scene& scene, const std::vector<const Material*>& materials, Needs& needs) {
    const auto first =
        std::find_if(materials.begin(), materials.end(), [](const Material* m) { return polarizes(*m); });
    if (first == materials.end()) {
        needs.reasons.emplace_back("light stays unpolarized: no surface has an interface or a filter");
        return;
    }
    needs.stokes = 3;
    bool circular_lamp = false;
    for (const Lamp& lamp : scene.lamps) {
        needs.polarized_lamps = needs.polarized_lamps || lamp.polarization != glm::vec3(0.0f);
        circular_lamp = circular_lamp || lamp.polarization.z != 0.0f;
    }
    if (circular_lamp) {
        needs.stokes = 4;
        needs.reasons.emplace_back("light may be circular: a lamp's own light is");
        return;
    }
    // One plane alone makes S1 in its own frame, which no retardance changes: S3 takes two that polarize.
    const auto polarizing_surfaces = std::count_if(scene.charts.begin(), scene.charts.end(), [&](const Chart& chart) {
        return polarizes(scene.materials[chart.material]);
    });
    const auto retarder =
        std::find_if(materials.begin(), materials.end(), [](const Material* m) { return retards(*m); });
    if (retarder != materials.end() && (polarizing_surfaces > 1 || needs.polarized_lamps)) {
        needs.stokes = 4;
        needs.reasons.push_back("light may be circular: polarized light can meet " + quoted(**retarder));
        return;
    }
    needs.reasons.push_back("light may be linearly polarized: " + quoted(**first) + " has " +
                            (((*first)->interface.present()) ? "an interface" : "a filter") +
                            "; never circular: nothing retards polarized light");
}

void find_bands(const Scene& scene, const std::vector<const Material*>& materials, Needs& needs) {
    const auto coloured = std::find_if(materials.begin(), materials.end(), [](const Material* m) { return !grey(*m); });
    if (coloured != materials.end()) {
        needs.reasons.push_back("three bands: " + quoted(**coloured) + " treats colours differently");
        return;
    }
    if (!scene.vertex_colors.empty()) {
        needs.reasons.emplace_back("three bands: vertices have colours");
        return;
    }
    std::optional<glm::vec3> colour;
    for (const Lamp& lamp : scene.lamps) {
        if (!(lamp.mean_power() > 0)) continue;
        const glm::vec3 own = lamp.power / lamp.mean_power();
        if (colour && glm::any(glm::greaterThan(glm::abs(own - *colour), glm::vec3(1e-6f)))) {
            needs.reasons.emplace_back("three bands: lamps have different colours");
            return;
        }
        if (!colour) colour = own;
    }
    needs.bands = 1;
    needs.colour = colour.value_or(glm::vec3(1.0f));
    needs.reasons.emplace_back("one band: all light has one colour, and every surface is grey");
}

}  // namespace

Needs needs_of(const Scene& scene) {
    Needs needs;
    const std::vector<const Material*> materials = used_materials(scene);
    find_stokes(scene, materials, needs);
    find_bands(scene, materials, needs);
    return needs;
}

}  // namespace brewster
