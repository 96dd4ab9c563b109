#include <imgui.h>

#include <algorithm>

#include "app/panels/desk.h"

namespace brewster {
namespace {

void heading(const Desk& desk, const char* words) {
    ImGui::Spacing();
    ImGui::TextColored(desk.preferences.light ? ImVec4(0.65f, 0.33f, 0, 1) : ImVec4(0.95f, 0.6f, 0.25f, 1), "%s",
                       words);
}

void rows_of(std::string_view group) {
    for (const KeyBinding& row : key_table()) {
        if (row.group != group || row.text.empty()) continue;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(std::string(row.chord).c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", std::string(row.text).c_str());
    }
}

}  // namespace

void help_window(Desk& desk) {
    if (!desk.shown.help) return;
    // The panels stay in sight, since it tells of them.
    ImVec2 size = ImGui::GetIO().DisplaySize;
    size.x -= static_cast<float>(column_width(desk.preferences.panels, desk.scale, static_cast<int>(size.x)));
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(860 * desk.scale, 0.97f * size.x), std::min(780 * desk.scale, 0.95f * size.y)},
                             ImGuiCond_Appearing);
    if (ImGui::Begin("help", &desk.shown.help, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ImGui::GetStyle().CellPadding.x, 0});  // all at once is seen
        if (ImGui::BeginTable("keys and mouse", 2)) {
            ImGui::TableNextRow();
            std::string_view group;
            for (const KeyBinding& row : key_table()) {
                if (row.group == group) continue;
                group = row.group;
                ImGui::TableNextColumn();
                heading(desk, std::string(group).c_str());
                if (ImGui::BeginTable(std::string(group).c_str(), 2, ImGuiTableFlags_RowBg)) {
                    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, 105 * desk.scale);
                    ImGui::TableSetupColumn("what");
                    rows_of(group);
                    ImGui::EndTable();
                }
            }
            ImGui::TableNextColumn();
            heading(desk, "Mouse");
            for (const MouseGesture& gesture : mouse_gestures())
                ImGui::TextWrapped("%s: %s", std::string(gesture.gesture).c_str(), std::string(gesture.text).c_str());
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
        ImGui::TextWrapped(
            "Sliders: Ctrl+click to type a number. Tab goes to the next number while one is typed, and otherwise hides "
            "the "
            "panels. Angles are from the "
            "picture's horizontal, counter-clockwise as the camera looks; right circular light has S3 > 0.");
    }
    ImGui::End();
}

void first_run_card(Desk& desk) {
    if (!desk.preferences.first_run) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({16 * desk.scale, 44 * desk.scale});
    const auto column = static_cast<float>(column_width(desk.preferences.panels, desk.scale, static_cast<int>(size.x)));
    ImGui::SetNextWindowSize({std::min(420 * desk.scale, size.x - column - 32 * desk.scale), 0});
    ImGui::Begin("welcome", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove);
    ImGui::TextWrapped("Drag to look around, wheel to come nearer.");
    ImGui::TextWrapped("P turns polarization off and on; A puts an analyzer in front, drag its wheel.");
    ImGui::TextWrapped("M on a surface, then drag its roughness or n. H shows every key.");
    if (ImGui::Button("got it")) desk.preferences.first_run = false;
    ImGui::End();
}

}  // namespace brewster
