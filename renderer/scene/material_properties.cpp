#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/units.h"
#include "optics/materials.h"
#include "scene/properties.h"

namespace brewster {
namespace {

double number(const PropertyValue& value) {
    return std::get<double>(value);
}
glm::vec3 bands(const PropertyValue& value) {
    return glm::vec3(std::get<glm::dvec3>(value));
}

bool is_no_filter(const Material& material) {
    return material.filter.kind == FilterKind::none;
}
bool is_opaque(const Material& material) {
    return material.base != Base::transparent;
}
bool can_be_rough(const Material& material) {
    return is_opaque(material) && material.interface.present();
}
bool can_be_coloured(const Material& material) {
    return is_opaque(material) && material.interface.kind != InterfaceKind::conductor;
}
bool is_filter(const Material& material) {
    return !is_no_filter(material);
}
bool is_retarder(const Material& material) {
    return material.filter.kind == FilterKind::retarder;
}
bool is_kirchhoff(const Material& material) {
    return material.interface.finish == Finish::kirchhoff;
}

// What enters is coloured by the albedo, or lost where there is none; without an interface all of it meets the base.
void choose_base(Material& material) {
    if (!is_opaque(material)) return;
    const bool reflecting = glm::any(glm::greaterThan(material.albedo, glm::vec3(0.0f)));
    if (!material.interface.present())
        material.base = Base::lambert;
    else if (material.interface.kind == InterfaceKind::dielectric)
        material.base = reflecting ? Base::polarized_diffuse : Base::black;
    else
        material.base = Base::black;
}

void set_medium(Material& material, glm::vec3 n, glm::vec3 k) {
    Interface& interface = material.interface;
    interface.n = n;
    interface.k = is_opaque(material) ? k : glm::vec3(0.0f);
    if (glm::any(glm::greaterThan(interface.k, glm::vec3(0.0f)))) {
        interface.kind = InterfaceKind::conductor;
        material.albedo = glm::vec3(0.0f);
    } else if (std::min({n.x, n.y, n.z}) >= static_cast<float>(least_index)) {
        interface.kind = InterfaceKind::dielectric;
    } else {
        interface = {};
    }
    choose_base(material);
}

glm::vec3 index_of(const Material& material) {
    return material.interface.present() ? material.interface.n : glm::vec3(1.0f);
}

PropertyValue medium_of(const Material& material) {
    for (const OpticalConstants& medium : named_materials) {
        const glm::vec3 n(medium.n[0], medium.n[1], medium.n[2]), k(medium.k[0], medium.k[1], medium.k[2]);
        const bool same_k =
            material.interface.kind != InterfaceKind::conductor ? k == glm::vec3(0.0f) : k == material.interface.k;
        if (material.interface.present() && n == material.interface.n && same_k) return std::string(medium.name);
    }
    return std::string();
}

void set_named_medium(Material& material, const PropertyValue& value) {
    const OpticalConstants& medium = *find_medium(std::get<std::string>(value));
    set_medium(material, glm::vec3(medium.n[0], medium.n[1], medium.n[2]),
               glm::vec3(medium.k[0], medium.k[1], medium.k[2]));
}

void set_slope(Material& material, double slope) {
    Interface& interface = material.interface;
    interface.finish = slope > 0 ? Finish::beckmann : Finish::smooth;
    interface.slope = static_cast<float>(slope);
    interface.rms_height = interface.correlation_length = 0;
}

void set_heights(Material& material, double rms_height, double correlation_length) {
    if (rms_height == 0) return set_slope(material, 0);
    const double slope = 2 * rms_height / correlation_length;
    if (slope > steepest_slope * (1 + 1e-6)) {
        throw Error("rmsHeight " + property_text(rms_height) + " um over correlationLength " +
                        property_text(correlation_length) + " um is a slope of " + property_text(slope),
                    material.name, "keep 2 rmsHeight / correlationLength at or below 0.8");
    }
    Interface& interface = material.interface;
    interface.finish = Finish::kirchhoff;
    interface.rms_height = static_cast<float>(rms_height);
    interface.correlation_length = static_cast<float>(correlation_length);
    interface.slope = static_cast<float>(slope);
}

void set_rms_height(Material& material, const PropertyValue& value) {
    // A surface that had no correlation length keeps its slope, or becomes a gentle one.
    constexpr double gentle = 0.1;
    const double slope = material.interface.finish == Finish::smooth ? gentle : material.interface.slope;
    const double length =
        is_kirchhoff(material) ? static_cast<double>(material.interface.correlation_length) : 2 * number(value) / slope;
    set_heights(material, number(value), length);
}

constexpr double largest_angle = 360;
const double roughest = std::sqrt(steepest_slope);

const std::array<Property<Material>, 11> rows{{
    {"albedo", PropertyType::bands, 0, 1, 0, 1, "",
     "share of the light inside the base that comes back, before textures", Change::retrace,
     "surfaces that are neither metal nor clear", can_be_coloured,
     [](const Material& m) -> PropertyValue { return glm::dvec3(m.albedo); },
     [](Material& m, const PropertyValue& value) {
         m.albedo = bands(value);
         choose_base(m);
     }},
    {"medium", PropertyType::medium, 0, 0, 0, 0, "", "water, glass, gold ...: n and k by name", Change::retrace,
     "all but filters", is_no_filter, medium_of, set_named_medium},
    {"n", PropertyType::bands, 1e-3, 100, 1, 12, "", "index of refraction; below 1.01 a surface has no interface",
     Change::retrace, "all but filters", is_no_filter,
     [](const Material& m) -> PropertyValue { return glm::dvec3(index_of(m)); },
     [](Material& m, const PropertyValue& value) { set_medium(m, bands(value), m.interface.k); }},
    {"k", PropertyType::bands, 0, 100, 0, 8, "", "absorption of a metal; 0 makes it clear again", Change::retrace,
     "surfaces that light does not pass", is_opaque,
     [](const Material& m) -> PropertyValue { return glm::dvec3(m.interface.k); },
     [](Material& m, const PropertyValue& value) { set_medium(m, index_of(m), bands(value)); }},
    {"roughness", PropertyType::number, 0, roughest, 0, roughest, "", "as in glTF, the root of m; 0 is smooth",
     Change::retrace, "surfaces with an interface (n) that light does not pass", can_be_rough,
     [](const Material& m) -> PropertyValue { return std::sqrt(static_cast<double>(m.interface.slope)); },
     [](Material& m, const PropertyValue& value) { set_slope(m, number(value) * number(value)); }},
    {"m", PropertyType::number, 0, steepest_slope, 0, steepest_slope, "", "Beckmann slope, 2 sigma / tau; 0 is smooth",
     Change::retrace, "surfaces with an interface (n) that light does not pass", can_be_rough,
     [](const Material& m) -> PropertyValue { return static_cast<double>(m.interface.slope); },
     [](Material& m, const PropertyValue& value) { set_slope(m, number(value)); }},
    {"rmsHeight", PropertyType::number, 0, 1e4, 0, 1, "um", "heights of a surface rough as waves see it; 0 is smooth",
     Change::retrace, "surfaces with an interface (n) that light does not pass", can_be_rough,
     [](const Material& m) -> PropertyValue { return static_cast<double>(m.interface.rms_height); }, set_rms_height},
    {"correlationLength", PropertyType::number, 1e-3, 1e5, 0.2, 50, "um", "distance over which heights change",
     Change::retrace, "surfaces with an rmsHeight", is_kirchhoff,
     [](const Material& m) -> PropertyValue { return static_cast<double>(m.interface.correlation_length); },
     [](Material& m, const PropertyValue& value) {
         set_heights(m, static_cast<double>(m.interface.rms_height), number(value));
     }},
    {"emission", PropertyType::bands, 0, 1e9, 0, 100, "cd/m2", "light of its own", Change::retrace, "all but filters",
     is_no_filter, [](const Material& m) -> PropertyValue { return glm::dvec3(m.emission); },
     [](Material& m, const PropertyValue& value) { m.emission = bands(value); }},
    {"angle", PropertyType::number, -largest_angle, largest_angle, -90, 90, "degrees",
     "of a polarizer's passing or a retarder's fast axis", Change::retrace, "filters", is_filter,
     [](const Material& m) -> PropertyValue { return degrees(static_cast<double>(m.filter.angle)); },
     [](Material& m, const PropertyValue& value) { m.filter.angle = static_cast<float>(radians(number(value))); }},
    {"retardance", PropertyType::bands, 0, largest_angle, 0, largest_angle, "degrees", "by which the slow axis lags",
     Change::retrace, "retarders", is_retarder,
     [](const Material& m) -> PropertyValue { return degrees(1.0) * glm::dvec3(m.filter.retardance); },
     [](Material& m, const PropertyValue& value) {
         m.filter.retardance = glm::mod(static_cast<float>(radians(1.0)) * bands(value), static_cast<float>(2 * pi));
     }},
}};

}  // namespace

std::span<const Property<Material>> material_properties() {
    return rows;
}

}  // namespace brewster
