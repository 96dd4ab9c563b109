#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace brewster::house {

/// Folder -> the folders it may include.
using Layers = std::map<std::string, std::set<std::string>>;

/// Reads layers.txt. What is wrong with it (a folder twice, an edge to a folder below) is appended to `complaints`.
Layers read_layers(std::istream& text, std::vector<std::string>& complaints);

struct SourceFile {
    std::string folder;  ///< of the house: "scene", "app"
    std::string path;    ///< from the root, for messages
    std::string text;
};

/// Every .h, .hpp, .c and .cpp file under renderer/ and app/.
std::vector<SourceFile> read_sources(const std::filesystem::path& root);

/// The names in a file's #include lines, with their quotes or angle brackets.
std::vector<std::string> includes_of(std::string_view text);

/// What the includes break, a sentence each: edges that layers.txt does not have, and foreign headers in wrong places.
std::vector<std::string> broken_rules(const std::vector<SourceFile>& files, const Layers& layers);

}  // namespace brewster::house
