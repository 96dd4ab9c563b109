// fuzz_seeds FOLDER: writes one file for each thing that the targets should start from, by the writers of the tests.
#include <filesystem>
#include <fstream>
#include <string>

#include "scene/mutations.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& folder, const std::string& name, const std::string& bytes) {
    fs::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << bytes;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace brewster;
    if (argc != 2) return 2;
    const fs::path scenes = fs::path(argv[1]) / "scene", settings = fs::path(argv[1]) / "settings";
    write(scenes, "whole.gltf", whole_file().text());
    write(scenes, "whole.glb", whole_file().glb());
    for (const Mutation& mutation : mutations()) {
        nlohmann::json file = nlohmann::json::parse(whole_file().text());
        mutation.change(file);
        write(scenes, mutation.name, file.dump());
    }
    for (const char* text :
         {"grey.albedo=0.2,0.4,0.6", "gold.medium=silver", "plastic.roughness=0.3", "plastic.ior=1.7",
          "wave.rmsHeight=0.2", "wave.correlationLength=3", "sheet.angle=45", "plate.retardance=180",
          "sun.direction=0,-1,0.5", "bulb.intensity=3", "grey.emission=1e3", "sun.angularDiameter=1"})
        write(settings, std::string(text).substr(0, std::string(text).find('=')), text);
}
