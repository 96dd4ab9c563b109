#include <imgui.h>

#include <cmath>

#include "app/numbers.h"
#include "app/panels/desk.h"

namespace brewster {
namespace {

void target_choice(Desk& desk) {
    const std::optional<double> target = desk.session.rule().target_error;
    auto percent = static_cast<float>(100 * target.value_or(0.0));
    ImGui::SetNextItemWidth(0.45f * ImGui::GetContentRegionAvail().x);
    static float entered = 0;
    if (!ImGui::IsAnyItemActive()) entered = percent;
    ImGui::InputFloat("stop at error", &entered, 0, 0, entered > 0 ? "%.3g %%" : "never");
    if (ImGui::IsItemDeactivatedAfterEdit())
        desk.set_target_error(entered > 0 ? std::optional(0.01 * static_cast<double>(entered)) : std::nullopt);
    if (!target || desk.progress.relative_error <= *target || desk.progress.relative_error <= 0) return;
    // The error falls with the root of the photons.
    const double ratio = desk.progress.relative_error / *target;
    ImGui::Text("about %s s more", significant(desk.progress.seconds * (ratio * ratio - 1), 2).c_str());
}

}  // namespace

void progress_panel(Desk& desk) {
    const Progress& progress = desk.progress;
    ImGui::Text("%s photons, %s a second", with_magnitude(static_cast<double>(progress.photons)).c_str(),
                with_magnitude(progress.photons_per_second()).c_str());
    ImGui::Text("error %.2g %%   %s cells   %sB", 100 * progress.relative_error,
                with_magnitude(static_cast<double>(progress.leaves + progress.gloss_leaves)).c_str(),
                with_magnitude(static_cast<double>(progress.bytes)).c_str());
    ImGui::Text("picture: %.0f samples%s", desk.samples, desk.gathered ? ", gathered" : "");
    if (desk.frame_ms > 0) {
        ImGui::SameLine();
        ImGui::Text("  frame %.0f ms", desk.frame_ms);
    }
    if (ImGui::Button(desk.session.paused() ? "go on (Space)" : "pause (Space)")) desk.act(Action::pause, 0);
    ImGui::SameLine();
    if (ImGui::Button("restart (Ctrl+R)")) desk.act(Action::restart, 0);
    if (ImGui::Button(desk.session.saving() ? "saving ..." : "save solution")) desk.save_solution();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("keeps the photons in a .bins file; open (O) and brewster shot --from take it up again");
    target_choice(desk);
    if (!desk.session.trouble().empty()) ImGui::TextWrapped("%s", desk.session.trouble().c_str());
    for (const std::string& warning : desk.scene.warnings) ImGui::TextDisabled("%s", warning.c_str());
}

}  // namespace brewster
