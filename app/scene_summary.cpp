#include "app/scene_summary.h"

#include <vector>

#include "app/numbers.h"
#include "base/units.h"

namespace brewster {
namespace {

template <class Vector>
std::string listed(Vector value) {
    return significant(static_cast<double>(value.x)) + " " + significant(static_cast<double>(value.y)) + " " +
           significant(static_cast<double>(value.z));
}

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

double area_of(const Scene& scene, std::uint32_t material) {
    double area = 0;
    for (const Chart& chart : scene.charts) {
        if (chart.material == material) area += chart.area;
    }
    return area;
}

std::string described(const Material& material) {
    std::string text = "Lambert, albedo " + listed(material.albedo);
    if (material.emits()) text += ", emits " + listed(material.emission) + " cd/m2";
    if (material.double_sided) text += ", both sides";
    return text;
}

std::string described(const Lamp& lamp) {
    std::string text(lamp_kind_name(lamp.kind));
    text += ", " + listed(lamp.power) + " lm";
    switch (lamp.kind) {
        case LampKind::area:
            break;
        case LampKind::sun:
            text += ", " + listed(lamp.intensity) + " lx across the beam";
            break;
        case LampKind::point:
        case LampKind::spot:
            text += ", " + listed(lamp.intensity) + " cd on its axis";
            break;
    }
    return text;
}

}  // namespace

std::string_view lamp_kind_name(LampKind kind) {
    switch (kind) {
        case LampKind::area:
            return "area";
        case LampKind::sun:
            return "sun";
        case LampKind::point:
            return "point";
        case LampKind::spot:
            return "spot";
    }
    return "";
}

std::string scene_summary(const Scene& scene) {
    std::string text = scene.name + ": " + counted(scene.triangles.size(), "triangle") + " on " +
                       counted(scene.charts.size(), "chart") + ", " + listed(scene.high - scene.low) + " m\n";

    text += "\nMaterials (red green blue)\n";
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        text += "  " + material.name + ": " + described(material) + ", on " + significant(area_of(scene, i)) + " m2\n";
    }
    text += "\nLamps\n";
    for (const Lamp& lamp : scene.lamps) text += "  " + lamp.name + ": " + described(lamp) + "\n";
    if (scene.lamps.empty()) text += "  none: nothing to trace\n";
    text += "\nCameras\n";
    for (const Camera& camera : scene.cameras) {
        text += "  " + camera.name + ": at " + listed(glm::dvec3(camera.position) + scene.centre) + " m, looking " +
                listed(camera.forward) + ", " +
                significant(degrees(static_cast<double>(camera.vertical_field_of_view))) + " degrees high\n";
    }
    text += "\nCharts\n";
    for (const Chart& chart : scene.charts) {
        text += "  " + chart.mesh + ": " + scene.materials[chart.material].name + ", " +
                significant(static_cast<double>(chart.size_u)) + " x " +
                significant(static_cast<double>(chart.size_v)) + " m, " + significant(chart.area) + " m2\n";
    }
    text += "\nNot simulated or mended\n";
    for (const std::string& warning : scene.warnings) text += "  " + warning + "\n";
    if (scene.warnings.empty()) text += "  nothing\n";
    return text;
}

}  // namespace brewster
