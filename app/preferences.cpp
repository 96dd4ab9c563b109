#include "app/preferences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/log.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t most_recent = 12;

Preferences from(const json& data) {
    Preferences preferences;
    preferences.text_scale = data.value("text_scale", preferences.text_scale);
    if (!(preferences.text_scale >= 0.8f && preferences.text_scale <= 2.0f))
        throw std::out_of_range("text_scale is not between 0.8 and 2");
    preferences.light = data.value("light", preferences.light);
    preferences.panels = data.value("panels", preferences.panels);
    preferences.first_run = data.value("first_run", preferences.first_run);
    preferences.palette = data.value("palette", preferences.palette);
    preferences.folder = data.value("folder", preferences.folder);
    preferences.recent_files = data.value("recent_files", preferences.recent_files);
    if (preferences.recent_files.size() > most_recent) preferences.recent_files.resize(most_recent);
    return preferences;
}

}  // namespace

std::string config_folder() {
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && *folder)
        return (fs::path(folder) / "brewster").string();
    if (const char* home = std::getenv("HOME"); home && *home) return (fs::path(home) / ".config/brewster").string();
    return "";
}

Preferences read_preferences(const std::string& folder, std::string& complaint) {
    const fs::path path = fs::path(folder) / "settings.json";
    std::ifstream stream(path);
    if (folder.empty() || !stream) return {};
    try {
        return from(json::parse(stream));
    } catch (const std::exception& error) {
        std::error_code fault;
        fs::rename(path, path.string() + ".broken", fault);
        complaint = path.string() + " cannot be understood (" + error.what() +
                    "); it is now called settings.json.broken, and the settings begin anew";
        return {};
    }
}

void write_preferences(const std::string& folder, const Preferences& preferences) {
    if (folder.empty()) return;
    std::error_code fault;
    fs::create_directories(folder, fault);
    const json data = {{"text_scale", std::round(100 * static_cast<double>(preferences.text_scale)) / 100},
                       {"light", preferences.light},
                       {"panels", preferences.panels},
                       {"first_run", preferences.first_run},
                       {"palette", preferences.palette},
                       {"folder", preferences.folder},
                       {"recent_files", preferences.recent_files}};
    const fs::path path = fs::path(folder) / "settings.json", beside = path.string() + ".new";
    {
        std::ofstream stream(beside);
        stream << data.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
        if (!stream) return log_warning("the settings cannot be kept: " + beside.string() + " cannot be written");
    }
    fs::rename(beside, path, fault);
}

}  // namespace brewster
