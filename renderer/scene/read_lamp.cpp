#include "scene/read_lamp.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/units.h"

namespace brewster {

Lamp read_lamp(const GltfLight& from, const std::string& name, const glm::dmat4& to_scene,
               std::vector<std::string>& warnings) {
    Lamp lamp;
    lamp.name = name;
    lamp.intensity = glm::vec3(from.intensity * glm::dvec3(from.color[0], from.color[1], from.color[2]));
    lamp.position = glm::vec3(glm::dvec3(to_scene[3]));
    lamp.direction = glm::vec3(glm::normalize(-glm::dvec3(to_scene[2])));
    lamp.axis = glm::vec3(glm::normalize(glm::dvec3(to_scene[0])));
    lamp.second_axis = glm::vec3(glm::normalize(glm::dvec3(to_scene[1])));
    const double turned = 2.0 * radians(from.aolp);
    lamp.polarization = glm::vec3(glm::dvec3(from.dolp * std::cos(turned), from.dolp * std::sin(turned), from.docp));
    if (from.type == "directional") {
        lamp.kind = LampKind::sun;
        lamp.angular_radius = static_cast<float>(0.5 * radians(from.angular_diameter));
    } else if (from.type == "point") {
        lamp.kind = LampKind::point;
        lamp.power = point_power(lamp.intensity);
    } else {
        lamp.kind = LampKind::spot;
        lamp.cos_inner = static_cast<float>(std::cos(from.inner_cone_angle));
        lamp.cos_outer = std::max(0.0f, static_cast<float>(std::cos(from.outer_cone_angle)));
        lamp.power = spot_power(lamp.intensity, lamp.cos_inner, lamp.cos_outer);
    }
    if (from.range > 0)
        warnings.push_back("light \"" + name + "\": its range is ignored; light falls off with the square of distance");
    return lamp;
}

glm::vec3 sun_power(const Scene& scene, const Lamp& sun) {
    return sun_rectangle(scene.low, scene.high, sun.direction, sun.angular_radius).area * sun.intensity;
}

void renew_area_lamps(Scene& scene) {
    std::erase_if(scene.lamps, [](const Lamp& lamp) { return lamp.kind == LampKind::area; });
    for (std::uint32_t i = 0; i < scene.charts.size(); ++i) {
        const Chart& chart = scene.charts[i];
        const Material& material = scene.materials[chart.material];
        if (!material.emits()) continue;
        Lamp lamp;
        lamp.name = chart.mesh;
        lamp.intensity = material.emission;
        lamp.power = static_cast<float>(pi * chart.area) * material.emission;
        lamp.chart = i;
        lamp.direction = chart.normal;
        scene.lamps.push_back(lamp);
    }
}

void complete_lamps(Scene& scene) {
    for (Lamp& lamp : scene.lamps)
        if (lamp.kind == LampKind::sun) lamp.power = sun_power(scene, lamp);
    renew_area_lamps(scene);
}

}  // namespace brewster
