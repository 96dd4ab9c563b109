#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/units.h"
#include "scene/properties.h"

namespace brewster {
namespace {

double number(const PropertyValue& value) {
    return std::get<double>(value);
}

bool is_no_surface(const Lamp& lamp) {
    return lamp.kind != LampKind::area;
}
bool has_direction(const Lamp& lamp) {
    return lamp.kind == LampKind::sun || lamp.kind == LampKind::spot;
}
bool is_sun(const Lamp& lamp) {
    return lamp.kind == LampKind::sun;
}

// Where the light comes from: degrees above the horizon, and from -z towards +x.
struct Bearing {
    double elevation, azimuth;
};

Bearing bearing_of(const Lamp& lamp) {
    const glm::dvec3 towards = -glm::dvec3(lamp.direction);
    return {degrees(std::asin(std::fmin(std::fmax(towards.y, -1.0), 1.0))), degrees(std::atan2(towards.x, -towards.z))};
}

void set_bearing(Lamp& lamp, const Bearing& bearing) {
    const double elevation = radians(bearing.elevation), azimuth = radians(bearing.azimuth);
    lamp.direction = glm::vec3(-std::cos(elevation) * std::sin(azimuth), -std::sin(elevation),
                               std::cos(elevation) * std::cos(azimuth));
}

double dolp_of(const Lamp& lamp) {
    return std::hypot(static_cast<double>(lamp.polarization.x), static_cast<double>(lamp.polarization.y));
}
double aolp_of(const Lamp& lamp) {
    return degrees(0.5 *
                   std::atan2(static_cast<double>(lamp.polarization.y), static_cast<double>(lamp.polarization.x)));
}

void set_state(Lamp& lamp, double dolp, double aolp, double docp) {
    if (dolp * dolp + docp * docp > 1 + 1e-6) {
        throw Error("dolp " + property_text(dolp) + " and docp " + property_text(docp) + " are more than all its light",
                    lamp.name, "keep dolp^2 + docp^2 at or below 1");
    }
    const double turned = 2 * radians(aolp);
    lamp.polarization = glm::vec3(dolp * std::cos(turned), dolp * std::sin(turned), docp);
}

const std::array<Property<Lamp>, 9> rows{{
    {"power", PropertyType::number, 0, 1e15, 0, 1e6, "lm", "mean of the bands, into the bounds of the scene",
     Change::retrace, "suns, points and spots", is_no_surface,
     [](const Lamp& l) -> PropertyValue { return static_cast<double>(l.mean_power()); },
     [](Lamp& l, const PropertyValue& value) {
         const double mean = static_cast<double>(l.mean_power());
         if (!(mean > 0)) throw Error("it gives no light that could be scaled", l.name, "set its intensity");
         l.intensity *= static_cast<float>(number(value) / mean);
     }},
    {"intensity", PropertyType::bands, 0, 1e12, 0, 1e5, "lx or cd",
     "of a sun across its beam (lx), of others on their axis (cd)", Change::retrace, "suns, points and spots",
     is_no_surface, [](const Lamp& l) -> PropertyValue { return glm::dvec3(l.intensity); },
     [](Lamp& l, const PropertyValue& value) { l.intensity = glm::vec3(std::get<glm::dvec3>(value)); }},
    {"direction", PropertyType::direction, -1e6, 1e6, -1, 1, "", "the way the light travels", Change::retrace,
     "suns and spots", has_direction, [](const Lamp& l) -> PropertyValue { return glm::dvec3(l.direction); },
     [](Lamp& l, const PropertyValue& value) { l.direction = glm::vec3(glm::normalize(std::get<glm::dvec3>(value))); }},
    {"elevation", PropertyType::number, -89, 89, -89, 89, "degrees", "above the horizon", Change::retrace,
     "suns and spots", has_direction, [](const Lamp& l) -> PropertyValue { return bearing_of(l).elevation; },
     [](Lamp& l, const PropertyValue& value) {
         set_bearing(l, {number(value), bearing_of(l).azimuth});
     }},
    {"azimuth", PropertyType::number, -180, 180, -180, 180, "degrees", "around the vertical, from -z towards +x",
     Change::retrace, "suns and spots", has_direction,
     [](const Lamp& l) -> PropertyValue { return bearing_of(l).azimuth; },
     [](Lamp& l, const PropertyValue& value) {
         set_bearing(l, {bearing_of(l).elevation, number(value)});
     }},
    {"angularDiameter", PropertyType::number, 0, 90, 0, 10, "degrees", "of the sun's disc", Change::retrace, "suns",
     is_sun, [](const Lamp& l) -> PropertyValue { return degrees(2.0 * static_cast<double>(l.angular_radius)); },
     [](Lamp& l, const PropertyValue& value) { l.angular_radius = static_cast<float>(radians(0.5 * number(value))); }},
    {"dolp", PropertyType::number, 0, 1, 0, 1, "", "linearly polarized share of its light", Change::retrace,
     "suns, points and spots", is_no_surface, [](const Lamp& l) -> PropertyValue { return dolp_of(l); },
     [](Lamp& l, const PropertyValue& value) {
         set_state(l, number(value), aolp_of(l), static_cast<double>(l.polarization.z));
     }},
    {"aolp", PropertyType::number, -180, 180, -90, 90, "degrees", "from the lamp's x axis, as the receiver sees it",
     Change::retrace, "suns, points and spots", is_no_surface,
     [](const Lamp& l) -> PropertyValue { return aolp_of(l); },
     [](Lamp& l, const PropertyValue& value) {
         set_state(l, dolp_of(l), number(value), static_cast<double>(l.polarization.z));
     }},
    {"docp", PropertyType::number, -1, 1, -1, 1, "", "circularly polarized share, right positive", Change::retrace,
     "suns, points and spots", is_no_surface,
     [](const Lamp& l) -> PropertyValue { return static_cast<double>(l.polarization.z); },
     [](Lamp& l, const PropertyValue& value) { set_state(l, dolp_of(l), aolp_of(l), number(value)); }},
}};

}  // namespace

std::span<const Property<Lamp>> lamp_properties() {
    return rows;
}

}  // namespace brewster
