#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/material_summary.h"
#include "app/panels/desk.h"
#include "app/panels/labels.h"
#include "base/units.h"

namespace brewster {
namespace {

constexpr ImU32 bright = IM_COL32(255, 255, 255, 230), faint = IM_COL32(255, 255, 255, 110),
                backing = IM_COL32(0, 0, 0, 110), orange = IM_COL32(240, 150, 50, 255);

bool something_polarizes(const Scene& scene) {
    return std::any_of(scene.charts.begin(), scene.charts.end(),
                       [&](const Chart& chart) { return polarizes(scene.materials[chart.material]).yes; });
}

ImVec2 on_circle(glm::vec2 middle, float radius, double angle) {
    // The screen's y axis points down, angles run counter-clockwise.
    const auto turn = static_cast<float>(radians(angle));
    return {middle.x + radius * std::cos(turn), middle.y - radius * std::sin(turn)};
}

void analyzer_kind_choice(Desk& desk) {
    Analyzer& analyzer = desk.view.rendition.analyzer;
    const auto choice = [&](const char* text, Analyzer::Kind kind) {
        if (ImGui::RadioButton(text, analyzer.kind == kind)) analyzer.kind = kind;
    };
    choice("none", Analyzer::Kind::none);
    ImGui::SameLine();
    choice("linear", Analyzer::Kind::linear);
    ImGui::SameLine();
    choice("right", Analyzer::Kind::right);
    ImGui::SameLine();
    choice("left", Analyzer::Kind::left);
}

}  // namespace

void polarization_panel(Desk& desk) {
    Sight& view = desk.view;
    if (!something_polarizes(desk.scene)) {
        ImGui::TextWrapped(
            "Nothing in this scene polarizes light: no surface has an interface, none is a filter. "
            "Give a material an index n to see Brewster's angle.");
    }
    bool polarization = view.rendition.polarization;
    if (ImGui::Checkbox("polarization (P)", &polarization)) desk.act(Action::polarization, 0);
    hint("off: the world where no surface tells polarizations apart; both are traced, so nothing is traced anew");
    ImGui::SameLine();
    ImGui::Checkbox("split (V)", &view.split);
    hint("polarization on to the left, off to the right of a line that can be dragged");
    bool difference = view.rendition.map == Map::difference;
    if (ImGui::Checkbox("difference on \u2212 off (D)", &difference)) desk.act(Action::difference, 0);
    hint("what polarization adds and takes, cd/m\u00b2");
    ImGui::SameLine();
    ImGui::TextDisabled("hold C: compare");

    ImGui::TextUnformatted("analyzer (A)");
    hint("an ideal filter in front of the camera: linear, or for right or left circular light");
    analyzer_kind_choice(desk);
    auto angle = static_cast<float>(view.analyzer_angle);
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize("angle (, .)").x - ImGui::GetStyle().ItemInnerSpacing.x);
    if (desk.shown.wants_field) ImGui::SetKeyboardFocusHere();
    desk.shown.wants_field = false;
    if (ImGui::SliderFloat("angle (, .)", &angle, -90, 90, "%.1f\u00b0")) {
        view.analyzer_angle = static_cast<double>(angle);
        view.rendition.analyzer.kind = Analyzer::Kind::linear;
    }
    hint("of the axis that passes, from the picture's horizontal, counter-clockwise as the camera looks");
}

void analyzer_wheel(Desk& desk, glm::vec2 middle, float radius) {
    Sight& view = desk.view;
    if (view.rendition.analyzer.kind == Analyzer::Kind::none) return;
    const float line = std::max(1.0f, 1.5f * desk.scale);
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    draw->AddCircleFilled({middle.x, middle.y}, 1.25f * radius, backing, 48);
    draw->AddCircle({middle.x, middle.y}, radius, bright, 48, line);
    // The frame: x to the right, positive angles counter-clockwise as the camera looks.
    draw->AddLine({middle.x, middle.y}, {middle.x + 1.12f * radius, middle.y}, faint, line);
    draw->AddText({middle.x + 1.05f * radius, middle.y + 0.04f * radius}, bright, "x");
    draw->PathArcTo({middle.x, middle.y}, 0.62f * radius, 0.0f, -0.9f, 16);
    draw->PathStroke(faint, 0, line);
    const ImVec2 tip = on_circle(middle, 0.62f * radius, 52);
    draw->AddTriangleFilled(tip, {tip.x + 0.10f * radius, tip.y + 0.02f * radius},
                            {tip.x + 0.03f * radius, tip.y + 0.12f * radius}, faint);
    draw->AddText({middle.x + 0.52f * radius, middle.y - 0.62f * radius}, bright, "+");
    if (view.rendition.analyzer.kind == Analyzer::Kind::linear) {
        draw->AddLine(on_circle(middle, radius, view.analyzer_angle),
                      on_circle(middle, radius, view.analyzer_angle + 180), orange, 2.5f * line);
        char text[32];
        std::snprintf(text, sizeof text, "%.1f\u00b0", view.analyzer_angle);
        const ImVec2 size = ImGui::CalcTextSize(text);
        draw->AddText({middle.x - 0.5f * size.x, middle.y + 0.45f * radius}, bright, text);
    } else {
        const bool right = view.rendition.analyzer.kind == Analyzer::Kind::right;
        const char* text = right ? "right: clockwise as the camera sees it" : "left: counter-clockwise";
        const ImVec2 size = ImGui::CalcTextSize(text);
        draw->AddRectFilled({middle.x - 0.5f * size.x - 4, middle.y - 0.5f * size.y},
                            {middle.x + 0.5f * size.x + 4, middle.y + 0.5f * size.y}, backing);
        draw->AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, bright, text);
    }

    // A window without looks takes the mouse from the picture.
    ImGui::SetNextWindowPos({middle.x - radius, middle.y - radius});
    ImGui::SetNextWindowSize({2 * radius, 2 * radius});
    ImGui::Begin("analyzer wheel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoMove);
    ImGui::SetCursorPos({0, 0});
    ImGui::InvisibleButton("turn", {2 * radius, 2 * radius});
    if (ImGui::IsItemActive()) {
        const ImVec2 at = ImGui::GetMousePos();
        if (std::hypot(at.x - middle.x, at.y - middle.y) > 0.1f * radius) {
            const double turn = std::atan2(static_cast<double>(middle.y - at.y), static_cast<double>(at.x - middle.x));
            view.analyzer_angle = in_half_turn(std::round(degrees(turn)));
            view.rendition.analyzer.kind = Analyzer::Kind::linear;
        }
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("drag to turn; , and . by 1\u00b0, with Shift by 10\u00b0");
    ImGui::End();
}

void split_slider(Desk& desk, glm::vec2 picture_size) {
    Sight& view = desk.view;
    if (!view.split) return;
    const float x = view.split_at * picture_size.x, grip = 8 * desk.scale;
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    draw->AddLine({x, 0}, {x, picture_size.y}, bright, std::max(1.0f, desk.scale));
    draw->AddCircleFilled({x, 0.5f * picture_size.y}, grip, orange);
    const float line = ImGui::GetTextLineHeight();
    const float away = 0.3f * line, inset = 0.3f * line;
    const auto label = [&](const char* text, bool on_the_left) {
        const ImVec2 size = ImGui::CalcTextSize(text);
        const float left = on_the_left ? x - away - 2 * inset - size.x : x + away;
        draw->AddRectFilled({left, 2 * line - 0.5f * inset}, {left + 2 * inset + size.x, 3 * line + 0.5f * inset},
                            backing);
        draw->AddText({left + inset, 2 * line}, bright, text);
    };
    label("polarization on", true);
    label("off", false);
    ImGui::SetNextWindowPos({x - grip, 0.0f});
    ImGui::SetNextWindowSize({2 * grip, picture_size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("split", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::SetCursorPos({0, 0});
    ImGui::InvisibleButton("move", {2 * grip, std::max(1.0f, picture_size.y)});
    if (ImGui::IsItemActive()) view.split_at = std::clamp(ImGui::GetMousePos().x / picture_size.x, 0.02f, 0.98f);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace brewster
