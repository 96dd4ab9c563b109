#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "house/include_rules.h"

namespace brewster::house {
namespace {

const std::filesystem::path root = BREWSTER_SOURCE_DIR;

Layers layers_on_disk(std::vector<std::string>& complaints) {
    std::ifstream text(root / "tests/layers.txt");
    return read_layers(text, complaints);
}

/// broken_rules for one made-up file.
std::vector<std::string> judge(const std::string& folder, const std::string& path, const std::string& line) {
    std::vector<std::string> complaints;
    const Layers layers = layers_on_disk(complaints);
    return broken_rules({{folder, path, line + "\n"}}, layers);
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(Layers, IncludesFollowTheAllowedEdges) {
    std::vector<std::string> complaints;
    const Layers layers = layers_on_disk(complaints);
    EXPECT_TRUE(complaints.empty()) << joined(complaints);
    const std::vector<SourceFile> files = read_sources(root);
    ASSERT_GT(files.size(), 50u) << "the sources were not found under " << root;
    const std::vector<std::string> broken = broken_rules(files, layers);
    EXPECT_TRUE(broken.empty()) << joined(broken);
}

TEST(Layers, ListNamesTheFoldersThatExist) {
    std::vector<std::string> complaints;
    std::set<std::string> listed, on_disk;
    for (const auto& [folder, edges] : layers_on_disk(complaints)) listed.insert(folder);
    for (const SourceFile& file : read_sources(root)) on_disk.insert(file.folder);
    EXPECT_EQ(listed, on_disk);
}

TEST(Layers, ForbiddenEdgeIsFound) {
    EXPECT_EQ(judge("bins", "renderer/bins/tree.cpp", "#include \"engine/engine.h\"").size(), 1u);
    EXPECT_EQ(judge("engine", "renderer/engine/engine.cpp", "  #  include \"display/picture.h\"").size(), 1u);
    EXPECT_EQ(judge("base", "renderer/base/error.h", "#include \"app/numbers.h\"").size(), 1u);
    EXPECT_TRUE(judge("engine", "renderer/engine/engine.cpp", "#include \"bins/snapshot.h\"").empty());
}

TEST(Layers, IncludeOutsideTheHouseIsFound) {
    EXPECT_EQ(judge("bins", "renderer/bins/tree.cpp", "#include \"utils/strings.h\"").size(), 1u);
    EXPECT_EQ(judge("bins", "renderer/bins/tree.cpp", "#include \"tree.h\"").size(), 1u);
    EXPECT_EQ(judge("bins", "renderer/bins/tree.cpp", "#include \"../bins/tree.h\"").size(), 1u);
    EXPECT_TRUE(judge("display", "renderer/display/text.cpp", "#include \"embedded_display.h\"").empty());
}

TEST(Layers, ForeignHeaderInTheWrongRoomIsFound) {
    EXPECT_EQ(judge("display", "renderer/display/gl.cpp", "#include <GLFW/glfw3.h>").size(), 1u);
    EXPECT_EQ(judge("engine", "renderer/engine/engine.cpp", "#include <imgui.h>").size(), 1u);
    EXPECT_EQ(judge("app", "app/window.cpp", "#include <glad/gl.h>").size(), 1u);
    EXPECT_EQ(judge("scene", "renderer/scene/read.cpp", "#include <CLI/CLI.hpp>").size(), 1u);
    EXPECT_EQ(judge("image", "renderer/image/exr.h", "#include <OpenEXR/ImfHeader.h>").size(), 1u);
    EXPECT_TRUE(judge("image", "renderer/image/exr.cpp", "#include <OpenEXR/ImfHeader.h>").empty());
}

TEST(Layers, HeavyHeaderInTwoFilesIsFound) {
    std::vector<std::string> complaints;
    const Layers layers = layers_on_disk(complaints);
    const std::string include = "#include <nlohmann/json.hpp>\n";
    EXPECT_EQ(broken_rules({{"app", "app/a.cpp", include}, {"app", "app/b.cpp", include}}, layers).size(), 1u);
    EXPECT_TRUE(broken_rules({{"app", "app/report.cpp", include}, {"app", "app/replay.cpp", include}}, layers).empty());
    EXPECT_TRUE(
        broken_rules({{"app", "app/a.cpp", include}, {"scene", "renderer/scene/b.cpp", include}}, layers).empty());
}

TEST(Layers, CircularListIsFound) {
    std::istringstream circle("bins: base\nbase: bins\n");
    std::vector<std::string> complaints;
    read_layers(circle, complaints);
    EXPECT_EQ(complaints.size(), 1u) << joined(complaints);
    std::istringstream twice("base:\nbase:\n");
    complaints.clear();
    read_layers(twice, complaints);
    EXPECT_EQ(complaints.size(), 1u) << joined(complaints);
}

}  // namespace
}  // namespace brewster::house
