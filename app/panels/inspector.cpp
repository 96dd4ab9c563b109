#include <imgui.h>

#include <array>
#include <cmath>

#include "app/numbers.h"
#include "app/panels/desk.h"
#include "app/panels/labels.h"

namespace brewster {
namespace {

constexpr ImU32 curve_colour = IM_COL32(110, 170, 255, 255), axis_colour = IM_COL32(140, 140, 140, 160),
                mark_colour = IM_COL32(240, 150, 50, 255);

/// The polarization ellipse as the camera sees it, x to the right, with the sense in which the field runs.
void ellipse(const SeenLight& light, float side) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const ImVec2 middle(corner.x + 0.5f * side, corner.y + 0.5f * side);
    draw->AddLine({corner.x, middle.y}, {corner.x + side, middle.y}, axis_colour);
    draw->AddLine({middle.x, corner.y}, {middle.x, corner.y + side}, axis_colour);
    const auto s = light.mean();
    const double polarized = std::sqrt(s[1] * s[1] + s[2] * s[2] + s[3] * s[3]);
    if (!(polarized > 0) || !(s[0] > 0)) return;
    const double turn = 0.5 * std::atan2(s[2], s[1]);
    const double narrow = 0.5 * std::asin(std::fmax(-1.0, std::fmin(1.0, s[3] / polarized)));
    const double radius = 0.46 * static_cast<double>(side) * std::sqrt(std::fmin(1.0, polarized / s[0]));
    constexpr int points = 48;
    std::array<ImVec2, points> outline;
    for (int i = 0; i < points; ++i) {
        // S3 > 0: clockwise as the receiver sees it.
        const double t = -2 * pi * i / points;
        const double x = std::cos(narrow) * std::cos(t), y = std::sin(narrow) * std::sin(t);
        outline[static_cast<std::size_t>(i)] = {
            middle.x + static_cast<float>(radius * (x * std::cos(turn) - y * std::sin(turn))),
            middle.y - static_cast<float>(radius * (x * std::sin(turn) + y * std::cos(turn)))};
    }
    draw->AddPolyline(outline.data(), points, curve_colour, ImDrawFlags_Closed, 2);
    draw->AddCircleFilled(outline[4], 3, mark_colour);
    draw->AddLine(outline[0], outline[4], mark_colour, 2);
}

/// What an analyzer at each angle lets through.
void intensity_curve(const SeenLight& light, double analyzer, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRect(corner, {corner.x + size.x, corner.y + size.y}, axis_colour);
    const auto place = [&](double angle) {
        return ImVec2(corner.x + size.x * static_cast<float>((angle + 90) / 180),
                      corner.y + size.y * static_cast<float>(1 - light.passed(angle)));
    };
    draw->AddLine({corner.x, corner.y + 0.5f * size.y}, {corner.x + size.x, corner.y + 0.5f * size.y}, axis_colour);
    draw->AddLine({corner.x + 0.5f * size.x, corner.y}, {corner.x + 0.5f * size.x, corner.y + size.y}, axis_colour);
    std::array<ImVec2, 61> curve;
    for (std::size_t i = 0; i < curve.size(); ++i) curve[i] = place(-90 + 3 * static_cast<double>(i));
    draw->AddPolyline(curve.data(), static_cast<int>(curve.size()), curve_colour, 0, 2);
    draw->AddCircleFilled(place(analyzer), 4, mark_colour);
}

void stokes_table(const SeenLight& light) {
    const ImVec2 padding = ImGui::GetStyle().CellPadding;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.5f * padding.x, padding.y});
    const bool open = ImGui::BeginTable("stokes", 5, ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchSame);
    ImGui::PopStyleVar();
    if (!open) return;
    ImGui::TableSetupColumn("cd/m\u00b2", ImGuiTableColumnFlags_WidthFixed);
    for (const char* heading : {"S0", "S1", "S2", "S3"}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    constexpr std::array<const char*, 3> bands = {"red", "green", "blue"};
    for (std::size_t band = 0; band < 3; ++band) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(bands[band]);
        for (std::size_t j = 0; j < 4; ++j) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(with_error(light.stokes[band][j], light.error[band][j]).c_str());
            ImGui::TextDisabled("\u00b1%s", with_error(light.error[band][j], light.error[band][j]).c_str());
        }
    }
    ImGui::EndTable();
}

void surface_lines(const Desk& desk, const SeenSurface& surface) {
    const Chart& chart = desk.scene.charts[surface.chart];
    ImGui::TextWrapped(
        "%s, of %s, at (%.3f, %.3f)", chart.mesh.c_str(), desk.scene.materials[surface.material].name.c_str(),
        static_cast<double>(surface.unit_coordinates.x), static_cast<double>(surface.unit_coordinates.y));
    ImGui::Text("seen at %.2f\u00b0 from the normal", surface.incidence_degrees);
    if (surface.brewster_degrees) {
        ImGui::Text("Brewster's angle %.2f\u00b0, %+.2f\u00b0 away", *surface.brewster_degrees,
                    surface.incidence_degrees - *surface.brewster_degrees);
    }
    if (const Engine* engine = desk.session.engine()) {
        if (const auto bins = engine->snapshot()) {
            const ChartBins& trees = bins->charts[surface.chart];
            ImGui::Text("chart %u: %u + %u bins of direct + indirect light", surface.chart, trees.direct_leaves,
                        trees.indirect_leaves);
            ImGui::Text("%s photons traced in all", with_magnitude(static_cast<double>(bins->photons)).c_str());
        }
    }
}

}  // namespace

void inspector_panel(Desk& desk) {
    if (!desk.light) {
        faint_text("point at the picture; Ctrl+drag for a mean");
        if (desk.surface) surface_lines(desk, *desk.surface);
        return;
    }
    const SeenLight& light = *desk.light;
    if (desk.region) ImGui::TextUnformatted("mean of the rectangle; Esc ends it");
    if (desk.view.rendition.analyzer.kind != Analyzer::Kind::none)
        faint_text("before the analyzer; the picture is behind it");
    stokes_table(light);
    const double floor = light.dolp_floor();
    ImGui::Text("%.4g cd/m\u00b2", light.luminance());
    ImGui::Text("DoLP %.1f \u00b1 %.1f %%   AoLP %.1f\u00b0   DoCP %+.1f %%", 100 * light.dolp(), 100 * floor,
                light.aolp_degrees(), 100 * light.docp());
    if (light.dolp() < 2 * floor) faint_text("no more than its noise: it may be unpolarized");
    const float side = 6 * ImGui::GetTextLineHeight();
    ellipse(light, side);
    ImGui::SameLine();
    intensity_curve(light, desk.view.analyzer_angle, {std::max(40.0f, ImGui::GetContentRegionAvail().x), side});
    faint_text("ellipse; share that an analyzer at \u221290\u00b0 .. 90\u00b0 lets through");
    if (desk.surface && !desk.region) surface_lines(desk, *desk.surface);
}

}  // namespace brewster
