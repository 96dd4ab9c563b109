#include <imgui.h>

#include "app/panels/desk.h"
#include "app/panels/labels.h"

namespace brewster {

void view_panel(Desk& desk) {
    Sight& view = desk.view;
    Rendition& rendition = view.rendition;
    ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    const std::string map_name = map_label(description(rendition.map).title);
    if (ImGui::BeginCombo("map (1..0)", map_name.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const MapDescription& entry : map_descriptions) {
            if (ImGui::Selectable(map_label(entry.title).c_str(), entry.map == rendition.map))
                rendition.map = entry.map;
        }
        ImGui::EndCombo();
    }
    hint("what of the light is shown, in colours that the legend explains; nothing is traced anew");
    ImGui::SliderFloat("exposure (E)", &rendition.exposure, -12, 12, "%+.2f EV");
    hint("each EV shows light twice as bright; Ctrl+click to type");
    if (ImGui::BeginCombo("camera (N)", view.camera.name.c_str())) {
        for (std::size_t i = 0; i < desk.scene.cameras.size(); ++i) {
            if (ImGui::Selectable(desk.scene.cameras[i].name.c_str(), desk.scene.cameras[i].name == view.camera.name))
                view.camera = desk.scene.cameras[i];
        }
        ImGui::EndCombo();
    }
    hint("cameras of the file; N and Shift+N go through them");
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
    hint("of signed maps: above and below zero");
    ImGui::PopItemWidth();
    ImGui::Checkbox("rays of the eye's own at rest (G)", &view.gather);
    hint("where nothing moves, rays from the eye settle the picture tile by tile; without them it is the bins alone");
    if (ImGui::Button("fit exposure (=)")) desk.act(Action::fit_exposure, 0);
    hint("as bright as the scene's first camera asks for");
    ImGui::SameLine();
    if (ImGui::Button("home (Home)")) desk.act(Action::home, 0);
    hint("back to the camera of the file");
    ImGui::SameLine();
    if (ImGui::Button("copy view")) desk.act(Action::copy_view, 0);
    hint("Ctrl+C: the view as text, which Ctrl+V and brewster shot --view take");
    ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    static float percent = 100;
    if (!ImGui::IsAnyItemActive()) percent = 100 * desk.preferences.text_scale;
    ImGui::SliderFloat("text", &percent, 80, 200, "%.0f %%");
    hint("size of all text, once it is let go");
    // Not while it is dragged: the slider would run from the pointer.
    if (ImGui::IsItemDeactivatedAfterEdit()) desk.preferences.text_scale = 0.01f * percent;
    ImGui::SameLine();
    ImGui::Checkbox("light", &desk.preferences.light);
    hint("panels dark on light");
}

}  // namespace brewster
