#include <imgui.h>

#include <cmath>

#include "app/numbers.h"
#include "app/panels/desk.h"
#include "app/panels/labels.h"

namespace brewster {
namespace {

void target_choice(Desk& desk) {
    const std::optional<double> target = desk.session.rule().target_error;
    auto percent = static_cast<float>(100 * target.value_or(0.0));
    ImGui::SetNextItemWidth(0.45f * ImGui::GetContentRegionAvail().x);
    static float entered = 0;
    if (!ImGui::IsAnyItemActive()) entered = percent;
    ImGui::InputFloat("stop at error", &entered, 0, 0, entered > 0 ? "%.3g %%" : "never");
    hint("photons stop once the error is as small; 0: never");
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
    if (desk.taking) {
        const std::string words = "saving the picture: " + std::to_string(static_cast<int>(100 * *desk.taking)) + " %";
        ImGui::ProgressBar(static_cast<float>(*desk.taking), {-1, 0}, words.c_str());
        hint("of its samples; Esc ends it");
    }
    ImGui::Text("%s photons traced, %s a second", with_magnitude(static_cast<double>(progress.photons)).c_str(),
                with_magnitude(progress.photons_per_second()).c_str());
    hint("since the scene was changed last");
    ImGui::Text("error %.2g %%   %s bins   %sB", 100 * progress.relative_error,
                with_magnitude(static_cast<double>(progress.leaves + progress.gloss_leaves)).c_str(),
                with_magnitude(static_cast<double>(progress.bytes)).c_str());
    hint("relative standard error of the bins' light, their number and their memory");
    if (desk.gathered > 0 && desk.gathered < 1)
        ImGui::Text("picture: %.0f %% gathered, %.3g samples", std::floor(100 * desk.gathered), desk.samples);
    else
        ImGui::Text("picture: %.3g samples%s", desk.samples, desk.gathered > 0 ? ", gathered" : "");
    hint("samples of each pixel, on the mean; gathered: by rays of the eye's own that end in bins");
    ImGui::Text("   of %s photons", with_magnitude(static_cast<double>(desk.photons_shown)).c_str());
    hint("whose bins the picture is made of, as its legend says; newer photons come with the next bins");
    if (desk.frame_ms > 0) {
        ImGui::SameLine();
        ImGui::Text("  frame %.0f ms", desk.frame_ms);
        hint("that the last picture took in which something moved");
    }
    if (ImGui::Button(desk.session.paused() ? "go on (Space)" : "pause (Space)")) desk.act(Action::pause, 0);
    hint("no photon flies while it is paused");
    ImGui::SameLine();
    if (ImGui::Button("restart (Ctrl+R)")) desk.act(Action::restart, 0);
    hint("traces the scene anew, from the first photon");
    if (ImGui::Button(desk.session.saving() ? "saving ..." : "save solution")) desk.save_solution();
    hint("keeps the photons in a .bins file; open (O) and brewster shot --from take it up again");
    target_choice(desk);
    if (!desk.session.trouble().empty()) ImGui::TextWrapped("%s", desk.session.trouble().c_str());
    for (const std::string& warning : desk.scene.warnings) ImGui::TextDisabled("%s", warning.c_str());
}

}  // namespace brewster
