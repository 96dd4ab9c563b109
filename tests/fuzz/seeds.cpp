// fuzz_seeds FOLDER: writes one file for each thing that the targets should start from, by the writers of the tests.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/preferences.h"
#include "engine/engine.h"
#include "scene/mutations.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& folder, const std::string& name, const std::string& bytes) {
    fs::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << bytes;
}

// A small solution of the whole file's scene; of a fixed grid, or with trees that grow.
void save_solution(const fs::path& folder, int fixed_grid_log2) {
    using namespace brewster;
    fs::create_directories(folder);
    EngineSettings settings;
    settings.bins.memory_bytes = std::size_t{1} << 20;
    settings.bins.fixed_grid_log2 = fixed_grid_log2;
    Engine engine(std::make_shared<const Scene>(read_scene_text(whole_file().text(), "whole")), settings);
    engine.start({2000, {}, {}});
    engine.wait();
    engine.save((folder / ("grid " + std::to_string(fixed_grid_log2))).string());
}

}  // namespace

int main(int argc, char** argv) {
    using namespace brewster;
    if (argc != 2) return 2;
    const fs::path scenes = fs::path(argv[1]) / "scene", settings = fs::path(argv[1]) / "settings";
    for (const int grid : {0, -1}) save_solution(fs::path(argv[1]) / "solution", grid);
    write(scenes, "whole.gltf", whole_file().text());
    write(scenes, "whole.glb", whole_file().glb());
    for (const Mutation& mutation : mutations()) {
        // Its neighbours place nearly ten million triangles: right, and 20 seconds under sanitizers.
        if (mutation.name == "ManyCopies") continue;
        nlohmann::json file = nlohmann::json::parse(whole_file().text());
        mutation.change(file);
        write(scenes, mutation.name, file.dump());
    }
    const fs::path views = fs::path(argv[1]) / "view", replays = fs::path(argv[1]) / "replay";
    write(views, "named",
          "camera=front size=640x480 ev=-1.5 map=dolp palette=red-green analyzer=30 samples=1e3 seed=7");
    write(views, "posed", "eye=1,2,3 target=0,-.5,1e-3 up=0,1,0 fov=40 polarization=off gather=on analyzer=right");
    for (const auto& script : fs::directory_iterator(BREWSTER_SOURCE_DIR "/tests/window"))
        if (script.path().extension() == ".json")
            write(replays, script.path().filename().string(),
                  (std::stringstream() << std::ifstream(script.path()).rdbuf()).str());
    write(replays, "every step", R"({"steps": [{"key": "Shift+,"}, {"hold": "C"}, {"let_go": "C"}, {"move": [0, 1]},
        {"click": [0.5, 0.5], "button": "right"}, {"wheel": 1, "at": [0, 0], "alt": true}, {"type": "0.3"},
        {"drag": [0, 0, 1, 1], "frames": 3, "measure": "drag", "shift": true}, {"set": "a.b=c"}, {"open": "a.gltf"},
        {"capture": "a.png"}, {"save": "a.exr"}, {"event": {"kind": 1, "at": [0, 0], "key": "A"}, "after": 0},
        {"expect": {"photons": {">": 1e6}, "bins": {"not": 0}}}, {"until": {"stale": false}, "seconds": 0},
        {"measure": "all", "seconds": 0}, {"wait": 0}], "seconds": 0})");
    Preferences preferences;
    preferences.recent_files = {"a.gltf", "b.glb"};
    write_preferences((fs::path(argv[1]) / "preferences").string(), preferences);
    for (const char* text :
         {"grey.albedo=0.2,0.4,0.6", "gold.medium=silver", "plastic.roughness=0.3", "plastic.ior=1.7",
          "wave.rmsHeight=0.2", "wave.correlationLength=3", "sheet.angle=45", "plate.retardance=180",
          "sun.direction=0,-1,0.5", "bulb.intensity=3", "grey.emission=1e3", "sun.angularDiameter=1"})
        write(settings, std::string(text).substr(0, std::string(text).find('=')), text);
}
