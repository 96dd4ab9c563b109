#include "app/scene_summary.h"

#include <algorithm>
#include <map>
#include <vector>

#include "app/material_summary.h"
#include "app/numbers.h"
#include "base/units.h"
#include "scene/needs.h"

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

std::string described(const Lamp& lamp) {
    std::string text(lamp_kind_name(lamp.kind));
    text += ", " + listed(lamp.power) + " lm";
    switch (lamp.kind) {
        case LampKind::area:
            text += ", " + listed(lamp.intensity) + " cd/m2";
            break;
        case LampKind::sun:
            text += ", " + listed(lamp.intensity) + " lx across the beam";
            break;
        case LampKind::point:
        case LampKind::spot:
            text += ", " + listed(lamp.intensity) + " cd on its axis";
            break;
    }
    if (lamp.polarization != glm::vec3(0.0f)) text += ", polarized: S1 S2 S3 " + listed(lamp.polarization);
    return text;
}

// A glowing mesh is one line, with the power of all its charts.
std::string lamp_lines(const Scene& scene) {
    std::vector<std::pair<Lamp, std::size_t>> sums;
    for (const Lamp& lamp : scene.lamps) {
        if (!sums.empty() && lamp.kind == LampKind::area && sums.back().first.kind == LampKind::area &&
            lamp.name == sums.back().first.name && lamp.intensity == sums.back().first.intensity) {
            sums.back().first.power += lamp.power;
            ++sums.back().second;
        } else {
            sums.emplace_back(lamp, 1);
        }
    }
    std::string text;
    for (const auto& [lamp, charts] : sums)
        text += "  " + lamp.name + ": " + described(lamp) + (charts > 1 ? ", " + counted(charts, "chart") : "") + "\n";
    return text;
}

// Charts of one mesh and material together: a curved mesh has thousands.
std::string chart_lines(const Scene& scene) {
    struct Sum {
        std::size_t charts = 0, triangles = 0;
        double area = 0;
        float largest = 0;
    };
    std::vector<std::pair<std::string, std::uint32_t>> order;
    std::map<std::pair<std::string, std::uint32_t>, Sum> sums;
    for (const Chart& chart : scene.charts) {
        const std::pair<std::string, std::uint32_t> key(chart.mesh, chart.material);
        Sum& sum = sums[key];
        if (sum.charts == 0) order.push_back(key);
        ++sum.charts;
        sum.triangles += chart.triangle_count;
        sum.area += chart.area;
        sum.largest = std::max(sum.largest, chart.size());
    }
    std::string text;
    for (const auto& key : order) {
        const Sum& sum = sums[key];
        text += "  " + key.first + ": " + scene.materials[key.second].name + ", " + counted(sum.charts, "chart") +
                " of " + counted(sum.triangles, "triangle") + ", " + significant(sum.area) + " m2, at most " +
                significant(static_cast<double>(sum.largest)) + " m long\n";
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

std::string_view lamp_intensity_unit(LampKind kind) {
    switch (kind) {
        case LampKind::area:
            return "cd/m2";
        case LampKind::sun:
            return "lx";
        case LampKind::point:
        case LampKind::spot:
            return "cd";
    }
    return "";
}

std::string scene_summary(const Scene& scene) {
    std::string text = scene.name + ": " + counted(scene.triangles.size(), "triangle") + " on " +
                       counted(scene.charts.size(), "chart") + ", " + listed(scene.high - scene.low) + " m\n";

    text += "\nMaterials (red green blue)\n";
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        text += "  " + material.name + ": " + described(scene, material) + ", on " + significant(area_of(scene, i)) +
                " m2\n";
        const auto [yes, why] = polarizes(material);
        text += std::string("    polarizes: ") + (yes ? "yes" : "no") + ", because " + why + "\n";
    }
    text += "\nLamps\n";
    text += lamp_lines(scene);
    if (scene.lamps.empty()) text += "  none: nothing to trace\n";
    text += "\nCameras\n";
    for (const Camera& camera : scene.cameras) {
        text += "  " + camera.name + ": at " + listed(glm::dvec3(camera.position) + scene.centre) + " m, looking " +
                listed(camera.forward) + ", " +
                significant(degrees(static_cast<double>(camera.vertical_field_of_view))) + " degrees high\n";
    }
    text += "\nCharts (both sides of a double-sided surface count)\n" + chart_lines(scene);
    const Needs needs = needs_of(scene);
    text += "\nTransport: " + counted(static_cast<std::size_t>(needs.stokes), "Stokes component") + " of " +
            counted(static_cast<std::size_t>(needs.bands), "band") + "\n";
    for (const std::string& reason : needs.reasons) text += "  " + reason + "\n";
    text += "\nNot simulated or mended\n";
    for (const std::string& warning : scene.warnings) text += "  " + warning + "\n";
    if (scene.warnings.empty()) text += "  nothing\n";
    return text;
}

}  // namespace brewster
