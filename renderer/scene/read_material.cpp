#include "scene/read_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>

#include "base/units.h"
#include "optics/materials.h"

namespace brewster {
namespace {

constexpr double highest_reflectance = 0.99;

std::string short_number(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", x);
    return text.data();
}

// KHR_materials_specular scales the reflectance at normal incidence; here the index that has it.
double index_of(const GltfMaterial& from, double specular_color) {
    constexpr double highest = 0.96;  // of an index of 99
    const double n = from.ior == 0.0 ? 1.5 : from.ior;
    const double reflectance = std::pow((n - 1.0) / (n + 1.0), 2) * specular_color;
    const double amplitude = std::sqrt(std::min(reflectance, highest) * from.specular);
    return (1.0 + amplitude) / (1.0 - amplitude);
}

bool white(const std::vector<double>& color) {
    return std::all_of(color.begin(), color.begin() + 3, [](double band) { return band == 1.0; });
}

// k of a metal of index n that reflects `reflectance` at normal incidence; below zero for an n that cannot.
double squared_absorption(double n, double reflectance) {
    return (reflectance * (n + 1.0) * (n + 1.0) - (n - 1.0) * (n - 1.0)) / (1.0 - reflectance);
}

double reflectance_of(const OpticalConstants& metal, std::size_t band) {
    const double n = metal.n[band], k = metal.k[band];
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

const OpticalConstants& nearest_metal(const glm::dvec3& reflectance) {
    const OpticalConstants* nearest = nullptr;
    double least = INFINITY;
    for (const OpticalConstants& metal : named_materials) {
        if (metal.k[0] == 0.0) continue;
        double distance = 0;
        for (int band = 0; band < 3; ++band)
            distance += std::pow(reflectance_of(metal, static_cast<std::size_t>(band)) - reflectance[band], 2);
        if (distance < least) {
            least = distance;
            nearest = &metal;
        }
    }
    return *nearest;
}

// A metal known by its colour only: n = 1 where it reflects less than half, otherwise that of the nearest metal known
// by name, and the k that gives its colour.
void set_metal_by_colour(Interface& interface, const std::vector<double>& colour) {
    const glm::dvec3 reflectance = glm::min(glm::dvec3(colour[0], colour[1], colour[2]), highest_reflectance);
    const OpticalConstants& metal = nearest_metal(reflectance);
    for (int band = 0; band < 3; ++band) {
        double n = reflectance[band] < 0.5 ? 1.0 : metal.n[static_cast<std::size_t>(band)];
        if (squared_absorption(n, reflectance[band]) < 0) n = 1.0;
        interface.n[band] = static_cast<float>(n);
        interface.k[band] = static_cast<float>(std::sqrt(squared_absorption(n, reflectance[band])));
    }
}

void set_finish(Material& material, const GltfMaterial& from, const std::string& subject,
                std::vector<std::string>& warnings) {
    Interface& interface = material.interface;
    const GltfSurface& surface = from.surface;
    const bool kirchhoff = surface.rms_height > 0;
    const double slope =
        kirchhoff ? 2.0 * surface.rms_height / surface.correlation_length : from.roughness * from.roughness;
    if (slope == 0.0) return;
    const double clamped = std::min(slope, steepest_slope);
    if (slope > steepest_slope)
        warnings.push_back(subject + "its roughness is taken as m = 0.8, the steepest that is simulated, instead of " +
                           short_number(slope));
    interface.finish = kirchhoff ? Finish::kirchhoff : Finish::beckmann;
    interface.slope = static_cast<float>(clamped);
    interface.rms_height = static_cast<float>(surface.rms_height);
    interface.correlation_length = static_cast<float>(kirchhoff ? 2.0 * surface.rms_height / clamped : 0.0);
}

void set_interface_and_base(Material& material, const GltfMaterial& from, const std::string& subject,
                            std::vector<std::string>& warnings) {
    Interface& interface = material.interface;
    const GltfSurface& surface = from.surface;
    const bool absorbs = std::any_of(surface.k.begin(), surface.k.end(), [](double k) { return k > 0.0; });
    const bool metal = from.metallic >= 0.5 || absorbs;
    const bool transparent = from.transmission >= 0.5 && !metal;
    for (int band = 0; band < 3; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const double tint = transparent ? 1.0 : from.specular_color[b];
        interface.n[band] = static_cast<float>(surface.n.empty() ? index_of(from, tint) : surface.n[b]);
        interface.k[band] = static_cast<float>(surface.k.empty() ? 0.0 : surface.k[b]);
    }
    const bool rarer = !metal && std::min({interface.n.x, interface.n.y, interface.n.z}) < 1.0f;
    if (rarer)
        warnings.push_back(subject + "an index below 1 without absorption is not simulated; it has no interface");
    constexpr auto least = static_cast<float>(least_index);
    const bool reflects = !rarer && std::max({interface.n.x, interface.n.y, interface.n.z}) >= least;
    if (metal) {
        interface.kind = InterfaceKind::conductor;
        material.base = Base::black;
        if (surface.n.empty()) set_metal_by_colour(interface, from.base_color);
    } else if (reflects) {
        interface.kind = InterfaceKind::dielectric;
        interface.n = glm::max(interface.n, least);
        material.base = transparent ? Base::transparent : Base::polarized_diffuse;
    } else {
        interface.kind = InterfaceKind::none;
        material.base = transparent ? Base::transparent : Base::lambert;
    }
    if (!metal && from.metallic > 0.0)
        warnings.push_back(subject + "its metallicFactor of " + short_number(from.metallic) +
                           " is taken as 0; a surface is a metal or is none");
    if (!absorbs && metal && from.metallic < 1.0)
        warnings.push_back(subject + "its metallicFactor of " + short_number(from.metallic) +
                           " is taken as 1; a surface is a metal or is none");
    if (!metal && !transparent && from.transmission > 0.0)
        warnings.push_back(subject + "it lets no light pass, not a part");
    if (material.base == Base::transparent) {
        if (from.transmission < 1.0) warnings.push_back(subject + "it lets light pass entirely, not in part");
        material.thin = from.thickness == 0.0;
        material.double_sided = true;  // light comes from both sides, whatever a file says of its look
        if (from.roughness > 0.0 || surface.rms_height > 0)
            warnings.push_back(subject + "its roughness is not simulated where light passes; it is smooth");
        if (from.attenuates || !white(from.base_color))
            warnings.push_back(subject + "its colour is not simulated where light passes; it is clear");
        if (surface.n.empty() && !white(from.specular_color))
            warnings.push_back(subject + "its specularColorFactor is not simulated where light passes");
    } else if (interface.present()) {
        set_finish(material, from, subject, warnings);
    }
    const bool has_base = material.base == Base::lambert || material.base == Base::polarized_diffuse;
    for (int band = 0; band < 3; ++band)
        material.albedo[band] = has_base ? static_cast<float>(from.base_color[static_cast<std::size_t>(band)]) : 0.0f;
    if (material.base == Base::polarized_diffuse && material.albedo == glm::vec3(0.0f)) material.base = Base::black;
}

void set_filter(Material& material, const GltfSurface& surface) {
    if (!surface.polarizer && !surface.retarder) return;
    Filter& filter = material.filter;
    filter.kind = surface.polarizer ? FilterKind::polarizer : FilterKind::retarder;
    filter.angle = static_cast<float>(radians(surface.angle));
    for (int band = 0; band < 3; ++band) {
        // A plate's retardance in turns, of which only the fraction counts.
        const double turns = surface.thickness > 0 ? surface.birefringence * surface.thickness * 1e3 /
                                                         band_wavelength_nm[static_cast<std::size_t>(band)]
                                                   : surface.retardance / 360.0;
        filter.retardance[band] = static_cast<float>(2.0 * pi * (turns - std::floor(turns)));
    }
    material.interface = {};
    material.base = Base::transparent;
    material.thin = true;
    material.albedo = glm::vec3(0.0f);
}

}  // namespace

std::string material_name(const GltfMaterial& material, std::size_t index) {
    return material.name.empty() ? "material " + std::to_string(index) : material.name;
}

Material read_material(const GltfMaterial& from, std::size_t index, std::vector<std::string>& warnings) {
    Material material;
    material.name = material_name(from, index);
    material.double_sided = from.double_sided;
    for (int band = 0; band < 3; ++band)
        material.emission[band] =
            static_cast<float>(from.emissive[static_cast<std::size_t>(band)] * from.emissive_strength);
    const std::string subject = "material \"" + material.name + "\": ";
    set_interface_and_base(material, from, subject, warnings);
    set_filter(material, from.surface);

    if (from.alpha_mode == "BLEND") warnings.push_back(subject + "its alpha mode BLEND is not simulated; it is opaque");
    return material;
}

Material default_material() {
    Material material;
    material.name = "default";
    return material;
}

}  // namespace brewster
