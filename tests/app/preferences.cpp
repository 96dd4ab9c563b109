#include "app/preferences.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "image/temporary_folder.h"

namespace brewster {
namespace {

TEST(Preferences, AreReadAsWritten) {
    const TemporaryFolder folder;
    Preferences preferences;
    preferences.text_scale = 1.25f;
    preferences.light = true;
    preferences.first_run = false;
    preferences.recent_files = {"/a b/c.gltf", "/d.glb"};
    write_preferences(folder.file("x/y"), preferences);
    std::string complaint;
    EXPECT_EQ(read_preferences(folder.file("x/y"), complaint), preferences);
    EXPECT_EQ(complaint, "");
}

TEST(Preferences, BrokenOnesAreSetAsideAndReported) {
    for (const char* text : {"{", "[]", R"({"text_scale": 90})", R"({"light": "yes"})", ""}) {
        const TemporaryFolder folder;
        std::ofstream(folder.file("settings.json")) << text;
        std::string complaint;
        EXPECT_EQ(read_preferences(folder.file(""), complaint), Preferences()) << text;
        EXPECT_NE(complaint.find("settings.json.broken"), std::string::npos) << text;
        EXPECT_TRUE(std::filesystem::exists(folder.file("settings.json.broken")));
        EXPECT_FALSE(std::filesystem::exists(folder.file("settings.json")));
    }
}

TEST(Preferences, NoneAreNoFault) {
    std::string complaint;
    EXPECT_EQ(read_preferences("", complaint), Preferences());
    EXPECT_EQ(read_preferences("/nowhere/at/all", complaint), Preferences());
    EXPECT_EQ(complaint, "");
}

}  // namespace
}  // namespace brewster
