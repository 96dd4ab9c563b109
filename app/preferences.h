#pragma once
#include <string>

#include "app/state.h"

namespace brewster {

/// $XDG_CONFIG_HOME/brewster, or ~/.config/brewster; empty where there is neither.
std::string config_folder();

/// Reads settings.json of the folder. A missing file gives the defaults. One that cannot be understood is renamed to
/// settings.json.broken, and `complaint` says so in a sentence.
Preferences read_preferences(const std::string& folder, std::string& complaint);

/// Writes it, by way of a file beside it, so that no half-written one is ever read. A folder that cannot be written to
/// is a warning.
void write_preferences(const std::string& folder, const Preferences& preferences);

}  // namespace brewster
