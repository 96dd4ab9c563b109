#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>

#include "app/panels/desk.h"
#include "app/scene_file.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;

/// A scene, or a saved solution.
bool can_be_opened(const fs::path& path) {
    return path.extension() == ".gltf" || path.extension() == ".glb" || is_solution(path.string());
}

/// Folders, then files, each in alphabetical order; what cannot be read is left out.
struct Listing {
    std::vector<std::string> folders, files;
    explicit Listing(const fs::path& folder) {
        std::error_code fault;
        for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
            const std::string name = at->path().filename().string();
            if (name.starts_with(".")) continue;
            std::error_code unknown;
            if (at->is_directory(unknown))
                folders.push_back(name);
            else if (can_be_opened(at->path()))
                files.push_back(name);
        }
        std::sort(folders.begin(), folders.end());
        std::sort(files.begin(), files.end());
    }
};

void folder_list(Desk& desk) {
    std::error_code fault;
    fs::path folder = desk.preferences.folder.empty() ? fs::current_path(fault) : fs::path(desk.preferences.folder);
    if (!fs::is_directory(folder, fault)) folder = fs::current_path(fault);
    static std::string typed;
    if (!ImGui::IsAnyItemActive()) typed = folder.string();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputText("##path", &typed, ImGuiInputTextFlags_EnterReturnsTrue);
    if (entered && fs::is_directory(typed, fault))
        desk.preferences.folder = typed;
    else if (entered)
        desk.open_file(typed);
    // Looked up anew only now and then: a folder can be large, and on a slow disc.
    static Listing listing(folder);
    static fs::path listed = folder;
    static double looked_at = ImGui::GetTime();
    if (listed != folder || ImGui::GetTime() - looked_at > 2) {
        listing = Listing(folder);
        listed = folder;
        looked_at = ImGui::GetTime();
    }
    ImGui::BeginChild("list", {0, -2.4f * ImGui::GetFrameHeightWithSpacing()}, true);
    if (ImGui::Selectable("..")) desk.preferences.folder = folder.parent_path().string();
    for (const std::string& name : listing.folders)
        if (ImGui::Selectable((name + "/").c_str())) desk.preferences.folder = (folder / name).string();
    for (const std::string& name : listing.files)
        if (ImGui::Selectable(name.c_str())) desk.open_file((folder / name).string());
    if (listing.folders.empty() && listing.files.empty()) ImGui::TextDisabled("no folder, no .gltf, no .glb, no .bins");
    ImGui::EndChild();
}

}  // namespace

void files_window(Desk& desk) {
    if (!desk.shown.files) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize({std::min(520 * desk.scale, 0.95f * size.x), std::min(560 * desk.scale, 0.95f * size.y)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    if (ImGui::Begin("open a scene", &desk.shown.files,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        ImGui::TextDisabled("glTF, GLB, or .bins (a saved solution of this scene); dropping works, too");
        const std::vector<std::string> recent = desk.preferences.recent_files;
        if (!recent.empty() && ImGui::BeginCombo("##recent", "recent files")) {
            for (const std::string& path : recent)
                if (ImGui::Selectable(path.c_str())) desk.open_file(path);
            ImGui::EndCombo();
        }
        folder_list(desk);
        ImGui::TextDisabled("save what is seen:");
        ImGui::SameLine();
        if (ImGui::Button("PNG")) desk.save(".png");
        ImGui::SameLine();
        if (ImGui::Button("EXR (linear Stokes)")) desk.save(".exr");
        if (ImGui::Button("close (Esc)")) desk.shown.files = false;
    }
    ImGui::End();
}

void complaint_window(Desk& desk) {
    if (desk.shown.complaint.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 0.3f * size.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(460 * desk.scale, 0.95f * size.x), 0});
    ImGui::Begin("that did not work", nullptr, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextWrapped("%s", desk.shown.complaint.c_str());
    if (ImGui::Button("copy")) desk.copy(desk.shown.complaint);
    ImGui::SameLine();
    if (ImGui::Button("close (Esc)")) desk.shown.complaint.clear();
    ImGui::End();
}

}  // namespace brewster
