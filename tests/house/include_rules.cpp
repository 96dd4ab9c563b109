#include "house/include_rules.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace brewster::house {
namespace {

namespace fs = std::filesystem;

/// Foreign headers whose names begin like this belong to one folder of the house.
const std::vector<std::pair<std::string, std::string>> home_of = {
    {"GLFW/", "app"},     {"imgui", "app"},   {"backends/imgui", "app"},
    {"glad/", "display"}, {"GL/", "display"}, {"CLI/", "app"},
};

/// Headers that take long to compile: each stands in one .cpp file of a folder and in no header.
const std::vector<std::string> heavy = {
    "CLI/",       "nlohmann/",        "tiny_gltf",           "OpenEXR/",      "Imf",
    "spdlog/",    "imgui_impl",       "backends/imgui_impl", "stb_truetype",  "stb_image_write",
    "stb_image.", "stb/stb_truetype", "stb/stb_image_write", "stb/stb_image."};

std::string first_folder(const std::string& name) {
    const std::size_t slash = name.find('/');
    return slash == std::string::npos ? "" : name.substr(0, slash);
}

/// Empty if `file` may include `name`, which is written in quotes.
std::string house_complaint(const SourceFile& file, const std::string& name, const Layers& layers) {
    if (name.starts_with("embedded_")) return "";
    const std::string folder = first_folder(name);
    if (folder != "shared" && !layers.contains(folder)) {
        return file.path + " includes \"" + name +
               "\", which is in no folder of the house; foreign headers stand in <>";
    }
    const auto allowed = layers.find(file.folder);
    const bool along_an_edge = allowed != layers.end() && allowed->second.contains(folder);
    if (folder == file.folder || along_an_edge) return "";
    return file.path + " includes \"" + name + "\": layers.txt has no edge " + file.folder + " -> " + folder;
}

/// The program has four kinds of JSON that share nothing but the library: what verbs report, what the window keeps, the
/// scripts it plays, and what those are told. A fifth file asks one of these.
const std::vector<std::string> files_of_json = {"app/report.cpp", "app/preferences.cpp", "app/replay.cpp",
                                                "app/scripted.cpp"};

bool is_file_of_json(const std::string& path, const std::string& prefix) {
    return prefix == "nlohmann/" && std::find(files_of_json.begin(), files_of_json.end(), path) != files_of_json.end();
}

}  // namespace

Layers read_layers(std::istream& text, std::vector<std::string>& complaints) {
    Layers layers;
    for (std::string line; std::getline(text, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words(line);
        std::string folder;
        words >> folder;
        if (!folder.ends_with(':')) {
            complaints.push_back("layers.txt: '" + line + "' does not begin with a folder and a colon");
            continue;
        }
        folder.pop_back();
        std::set<std::string> edges;
        for (std::string edge; words >> edge;) {
            if (edge != "shared" && !layers.contains(edge)) {
                complaints.push_back("layers.txt: " + folder + " -> " + edge + " leads to no folder above it");
            }
            edges.insert(edge);
        }
        if (!layers.emplace(folder, edges).second) complaints.push_back("layers.txt: " + folder + " stands twice");
    }
    return layers;
}

std::vector<SourceFile> read_sources(const fs::path& root) {
    std::vector<SourceFile> files;
    const auto add_folder = [&](const std::string& name, const fs::path& folder) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".h" && ending != ".hpp" && ending != ".c" && ending != ".cpp") continue;
            std::ifstream stream(entry.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            files.push_back({name, fs::relative(entry.path(), root).string(), text});
        }
    };
    for (const fs::directory_entry& folder : fs::directory_iterator(root / "renderer")) {
        if (folder.is_directory()) add_folder(folder.path().filename().string(), folder.path());
    }
    add_folder("app", root / "app");
    return files;
}

std::vector<std::string> includes_of(std::string_view text) {
    static const std::regex include(R"re(^\s*#\s*include\s*("[^"]*"|<[^>]*>))re");
    std::vector<std::string> names;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, include)) names.push_back(match[1]);
    }
    return names;
}

std::vector<std::string> broken_rules(const std::vector<SourceFile>& files, const Layers& layers) {
    std::vector<std::string> complaints;
    std::map<std::pair<std::string, std::string>, std::set<std::string>> users_of_heavy;
    for (const SourceFile& file : files) {
        for (const std::string& written : includes_of(file.text)) {
            const std::string name = written.substr(1, written.size() - 2);
            if (written.front() == '"') {
                if (std::string complaint = house_complaint(file, name, layers); !complaint.empty()) {
                    complaints.push_back(std::move(complaint));
                }
                continue;
            }
            for (const auto& [prefix, home] : home_of) {
                if (name.starts_with(prefix) && file.folder != home) {
                    complaints.push_back(file.path + " includes <" + name + ">, which belongs to " + home + " only");
                }
            }
            for (const std::string& prefix : heavy) {
                if (!name.starts_with(prefix)) continue;
                if (!is_file_of_json(file.path, prefix)) users_of_heavy[{prefix, file.folder}].insert(file.path);
                if (!file.path.ends_with(".cpp") && !name.ends_with("_fwd.hpp")) {
                    complaints.push_back(file.path + " includes <" + name + ">, which is too heavy for a header");
                }
            }
        }
    }
    for (const auto& [prefix_and_folder, users] : users_of_heavy) {
        if (users.size() < 2) continue;
        std::string list;
        for (const std::string& user : users) list += " " + user;
        complaints.push_back("<" + prefix_and_folder.first + "...> may stand in one file of a folder, but stands in" +
                             list);
    }
    return complaints;
}

}  // namespace brewster::house
