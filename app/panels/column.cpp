#include <imgui.h>

#include <algorithm>

#include "app/panels/desk.h"
#include "app/panels/labels.h"

namespace brewster {
namespace {

constexpr float width_at_scale_1 = 330;
constexpr int narrowest_picture = 200;  // pixels; below, the panels give way

void section(Desk& desk, const char* title, void (*panel)(Desk&), bool open) {
    if (!ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return;
    ImGui::PushID(title);
    panel(desk);
    ImGui::PopID();
    ImGui::Spacing();
}

}  // namespace

int column_width(bool panels, float scale, int window_width) {
    const auto width = static_cast<int>(width_at_scale_1 * scale);
    return panels && window_width - width >= narrowest_picture ? width : 0;
}

void panel_column(Desk& desk, glm::ivec2 window_size) {
    const int width = column_width(desk.preferences.panels, desk.scale, window_size.x);
    if (width == 0) return;
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    const float share = static_cast<float>(width) / static_cast<float>(window_size.x);
    ImGui::SetNextWindowPos({whole.x * (1 - share), 0});
    ImGui::SetNextWindowSize({whole.x * share, whole.y});
    ImGui::Begin("panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_AlwaysVerticalScrollbar);
    if (ImGui::Button("open (O)")) desk.act(Action::open, 0);
    hint("a scene, or a saved solution");
    ImGui::SameLine();
    if (ImGui::Button("help (H)")) desk.act(Action::help, 0);
    ImGui::SameLine();
    if (ImGui::Button("save (F12)")) desk.act(Action::picture, 0);
    hint("the picture, as PNG beside where the program was started; Ctrl+F12: without its legend; EXR: open (O)");
    ImGui::SameLine();
    if (ImGui::Button("hide (Tab)")) desk.act(Action::panels, 0);
    if (desk.shown.wants_field) ImGui::SetNextItemOpen(true);
    section(desk, "Polarization", polarization_panel, true);
    section(desk, "View", view_panel, true);
    section(desk, "Materials and lamps", materials_panel, true);
    if (desk.shown.inspector) section(desk, "Inspector (I)", inspector_panel, true);
    section(desk, "Progress", progress_panel, true);
    ImGui::End();
}

}  // namespace brewster
