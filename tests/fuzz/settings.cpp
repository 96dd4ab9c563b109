// Any text as the value of --set: refused, an Error, or a change after which the scene still keeps all promises, and
// which says itself again.
#include "app/settings.h"

#include <string>

#include "base/error.h"
#include "fuzz/promises.h"
#include "scene/gltf_builder.h"
#include "scene/mutations.h"
#include "scene/scene.h"

namespace {

// A material of each kind and a lamp of each.
brewster::Scene scene_of_everything() {
    using nlohmann::json;
    brewster::GltfBuilder file = brewster::whole_file();
    auto& materials = file.json["materials"];
    for (const char* text : {R"({"name": "plastic", "pbrMetallicRoughness": {"metallicFactor": 0}})",
                             R"({"name": "gold", "pbrMetallicRoughness": {"roughnessFactor": 0.1}})",
                             R"({"name": "glass", "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
                                 "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})",
                             R"({"name": "wave", "extensions": {"BREWSTER_surface": {"rmsHeight": 0.1,
                                 "correlationLength": 1}}})",
                             R"({"name": "sheet", "extensions": {"BREWSTER_surface": {"polarizer": {"angle": 0}}}})",
                             R"({"name": "plate", "extensions": {"BREWSTER_surface": {"retarder": {"angle": 0,
                                 "retardance": 90}}}})"}) {
        materials.push_back(json::parse(text));
        file.add_polygon("of " + std::to_string(materials.size()), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                         static_cast<int>(materials.size()) - 1);
    }
    auto& lights = file.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "directional"}});
    lights.push_back({{"type", "point"}});
    for (const int light : {1, 2})
        file.add_node(
            {{"name", light == 1 ? "sun" : "bulb"}, {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    return brewster::read_scene_text(file.text(), "everything");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    static const Scene everything = scene_of_everything();
    const std::optional<Setting> setting = parse_setting({reinterpret_cast<const char*>(data), size});
    if (!setting) return 0;
    Scene scene = everything;
    try {
        apply_settings(scene, {*setting});
        check_scene(scene);
    } catch (const Error& error) {
        promise(std::string(error.what()).size() > 10, "an error says something");
    }
    return 0;
}
