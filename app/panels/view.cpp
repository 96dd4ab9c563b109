#include <imgui.h>

#include "app/panels/desk.h"

namespace brewster {

void view_panel(Desk& desk) {
    Sight& view = desk.view;
    Rendition& rendition = view.rendition;
    ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    const std::string map_name(description(rendition.map).name);
    if (ImGui::BeginCombo("map (1..0)", map_name.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const MapDescription& entry : map_descriptions) {
            const std::string title(entry.title);
            if (ImGui::Selectable(title.c_str(), entry.map == rendition.map)) rendition.map = entry.map;
        }
        ImGui::EndCombo();
    }
    ImGui::SliderFloat("exposure (E)", &rendition.exposure, -12, 12, "%+.2f EV");
    if (ImGui::BeginCombo("camera (N)", view.camera.name.c_str())) {
        for (std::size_t i = 0; i < desk.scene.cameras.size(); ++i) {
            if (ImGui::Selectable(desk.scene.cameras[i].name.c_str(), desk.scene.cameras[i].name == view.camera.name))
                view.camera = desk.scene.cameras[i];
        }
        ImGui::EndCombo();
    }
    const std::string colours(palette_name(rendition.palette));
    if (ImGui::BeginCombo("colours", colours.c_str())) {
        for (const PaletteDescription& entry : palette_descriptions) {
            const std::string name(entry.name);
            if (ImGui::Selectable(name.c_str(), entry.palette == rendition.palette)) {
                rendition.palette = entry.palette;
                desk.preferences.palette = name;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::PopItemWidth();
    ImGui::Checkbox("rays of the eye's own at rest (G)", &view.gather);
    if (ImGui::Button("fit exposure (=)")) desk.act(Action::fit_exposure, 0);
    ImGui::SameLine();
    if (ImGui::Button("home (Home)")) desk.act(Action::home, 0);
    ImGui::SameLine();
    if (ImGui::Button("copy view")) desk.act(Action::copy_view, 0);
    ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    static float percent = 100;
    if (!ImGui::IsAnyItemActive()) percent = 100 * desk.preferences.text_scale;
    ImGui::SliderFloat("text", &percent, 80, 200, "%.0f %%");
    // Not while it is dragged: the slider would run from the pointer.
    if (ImGui::IsItemDeactivatedAfterEdit()) desk.preferences.text_scale = 0.01f * percent;
    ImGui::SameLine();
    ImGui::Checkbox("light", &desk.preferences.light);
}

}  // namespace brewster
