#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/process.h"
#include "scene/mutations.h"

namespace brewster {
namespace {

using nlohmann::json;

// Each broken file of tests/scene, given to the program: one sentence, exit code 1, nothing on standard output.
TEST(Files, BrokenOnesEndInOneSentence) {
    const std::string folder = fresh_folder();
    ASSERT_GE(mutations().size(), 80u);
    for (const Mutation& mutation : mutations()) {
        json file = json::parse(whole_file().text());
        mutation.change(file);
        const std::string path = folder + "/" + mutation.name + ".gltf";
        write_text(path, file.dump());
        const ProcessResult result = run_process({brewster_program(), "info", path});
        EXPECT_EQ(result.exit_code, 1) << mutation.name << "\n" << result.errors;
        EXPECT_EQ(result.output, "") << mutation.name;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        // What a file beside it could mend reads differently where there is a folder to look in.
        if (mutation.name != "FileForAnEmbeddedScene") {
            EXPECT_NE(result.errors.find(mutation.words), std::string::npos) << mutation.name << "\n" << result.errors;
        }
    }
}

struct Room {
    std::string binary, separate;
    std::vector<std::string> cameras;
    std::size_t lamps;
};

// Rooms as Blender writes them (tests/scene/blender): both forms are the same scene, down to the photons, and nothing
// that they hold goes unread.
TEST(Files, RoomsMadeWithBlenderOpen) {
    const std::string folder = std::string(BREWSTER_SOURCE_DIR) + "/tests/scene/blender/";
    const std::vector<Room> rooms = {
        {"glass and brass.glb", "glass and brass/glass and brass.gltf", {"Camera.main", "Camera.low"}, 3},
        {"sculpture.glb", "a head by the window/sculpture.gltf", {"Camera.main"}, 3},
        {"gallery.glb", "gallery room/gallery.gltf", {"Camera.main"}, 2},
    };
    for (const Room& room : rooms) {
        std::vector<json> reports, solutions;
        for (const std::string& name : {room.binary, room.separate}) {
            const ProcessResult info = run_process({brewster_program(), "info", folder + name, "--json"});
            ASSERT_EQ(info.exit_code, 0) << info.errors;
            reports.push_back(json::parse(info.output));
            const ProcessResult solve =
                run_process({brewster_program(), "solve", folder + name, "--photons", "2000", "--json"});
            ASSERT_EQ(solve.exit_code, 0) << solve.errors;
            solutions.push_back(json::parse(solve.output));
        }
        EXPECT_EQ(reports[0], reports[1]) << room.binary;
        EXPECT_EQ(solutions[0]["digest"], solutions[1]["digest"]) << room.binary;
        EXPECT_EQ(solutions[0]["trouble"], 0);
        ASSERT_EQ(reports[0]["cameras"].size(), room.cameras.size());
        for (std::size_t i = 0; i < room.cameras.size(); ++i)
            EXPECT_EQ(reports[0]["cameras"][i]["name"], room.cameras[i]);
        EXPECT_EQ(reports[0]["lamps"].size(), room.lamps) << room.binary;
        for (const json& material : reports[0]["materials"]) EXPECT_EQ(material["double_sided"], true);
        // There is nothing to say but of the glass ball: it has no thickness in the file, and its look is beyond bins.
        for (const json& warning : reports[0]["warnings"])
            EXPECT_EQ(warning.get<std::string>().rfind("material \"Glass\": ", 0), 0u) << warning;
    }
}

}  // namespace
}  // namespace brewster
