#include "app/replay.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace brewster {
namespace {

/// What the script ends in before a window that does nothing: a sentence, or "played".
std::string end_of(const std::string& script) {
    const auto path = std::filesystem::temp_directory_path() / "brewster-replay-test.json";
    std::ofstream(path) << script;
    Stage stage;
    stage.input = [](const InputEvent&) {};
    stage.state = [] {
        return nlohmann::json{
            {"picture", {640, 480}}, {"photons", 1}, {"bins", true}, {"generation", 1}, {"milliseconds", 1}};
    };
    try {
        Replay replay(path.string(), "/dev/null");
        for (int frame = 0; frame < 50; ++frame) {
            if (!replay.advance(stage)) return "played";
            replay.presented(1, stage);
            EXPECT_GE(replay.patience(), 0);
        }
        return "never ends";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Replay, PlaysWhatIsAStepAndRefusesAllElse) {
    EXPECT_EQ(end_of(R"({"steps": [{"move": [0.5, 0.5]}, {"drag": [0, 0, 1, 1], "frames": 2}]})"), "played");
    for (const char* script :
         {"", "[]", R"({"steps": 3})", R"({"steps": {"a": {"wait": 1}}})", R"({"steps": [7]})",
          R"({"steps": [{"move": [0.5]}]})", R"({"steps": [{"resize": [640]}]})", R"({"steps": [{"wheel": 1}]})",
          R"({"steps": [{"wait": "long"}]})", R"({"steps": [{"event": {"kind": 1}}]})",
          R"({"steps": [{"event": {"at": [0, 0], "kind": 1e30}}]})",
          R"({"steps": [{"event": {"at": [0, 0], "kind": 6}}]})", R"({"steps": [{"resize": [0, 480]}]})",
          R"({"steps": [{"resize": [640, 1e10]}]})", R"({"steps": [{"drag": [0, 0, 1, 1], "frames": -3}]})",
          R"({"steps": [{"move": [0, 1], "wait": "x"}, {"dance": 1}]})"}) {
        const std::string end = end_of(script);
        EXPECT_NE(end.find("brewster-replay-test.json: "), std::string::npos) << script << " ends in: " << end;
        EXPECT_EQ(end.find('\n'), std::string::npos) << end;
    }
}

}  // namespace
}  // namespace brewster
