#include "scene/read_material.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace brewster {
namespace {

std::string short_number(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", x);
    return text.data();
}

// The interface over the base, in words; empty if there is none (KHR_materials_specular: factor 0).
std::string interface_of(const GltfMaterial& from) {
    if (from.metallic >= 0.5) return "its metal";
    if (from.specular == 0.0 || from.ior == 1.0) return {};
    return "its glossy interface (refractive index " + short_number(from.ior) + ")";
}

}  // namespace

Material read_material(const GltfMaterial& from, std::size_t index, std::vector<std::string>& warnings) {
    Material material;
    material.name = from.name.empty() ? "material " + std::to_string(index) : from.name;
    material.double_sided = from.double_sided;
    for (int band = 0; band < 3; ++band) {
        const auto k = static_cast<std::size_t>(band);
        material.albedo[band] = static_cast<float>(from.base_color[k]);
        material.emission[band] = static_cast<float>(from.emissive[k] * from.emissive_strength);
    }

    const std::string subject = "material \"" + material.name + "\": ";
    if (const std::string interface = interface_of(from); !interface.empty())
        warnings.push_back(subject + interface + " is not simulated; it is a Lambert surface of its base colour");
    for (const std::string& texture : from.textures)
        warnings.push_back(subject + texture + " is not read; the factor beside it is used alone");
    for (const char* name : {"KHR_materials_transmission", "KHR_materials_volume", "BREWSTER_surface"})
        if (std::find(from.extensions.begin(), from.extensions.end(), name) != from.extensions.end())
            warnings.push_back(subject + name + " is not simulated");
    if (from.alpha_mode != "OPAQUE")
        warnings.push_back(subject + "its alpha mode " + from.alpha_mode + " is not simulated; it is opaque");
    return material;
}

Material default_material() {
    Material material;
    material.name = "default";
    return material;
}

}  // namespace brewster
