#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/process.h"
#include "image/png.h"
#include "scene/gltf_builder.h"

/// Gathered pictures as the program writes them.
namespace brewster {
namespace {

using nlohmann::json;

json report_of(std::vector<std::string> arguments, const std::string& folder) {
    arguments.insert(arguments.begin(), brewster_program());
    arguments.emplace_back("--json");
    ProcessSetting setting;
    setting.folder = folder;
    const ProcessResult result = run_process(arguments, setting);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(result.output);
}

/// On and off end in the same bins of the Cornell box, but off takes direct light from them, too. The camera sees more than
/// 30 cells that err on their own, so the means of the pictures differ by at most 3 / sqrt(30) of the bins' stated error.
TEST(Gathered, AgreesWithTheBinsOfADiffuseScene) {
    const std::string folder = fresh_folder();
    const auto shot = [&](const std::string& gather) {
        return report_of({"shot", BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf", "--photons", "4e5", "--camera",
                          "inside", "--size", "32x32", "--samples", "32", "--gather", gather, "--out", gather + ".exr"},
                         folder);
    };
    shot("off");
    const double stated = shot("on")["gather"]["relative_error"]["bins"];
    EXPECT_GT(stated, 1e-4);
    EXPECT_LT(stated, 0.06);  // so that 5 % would be noticed
    const json components = report_of({"compare", "on.exr", "off.exr"}, folder)["components"];
    for (const char* band : {"R", "G", "B"}) {
        const json& s0 = components["S0"][band];
        const double bias = s0["bias"].get<double>() / s0["reference_mean"].get<double>();
        EXPECT_LT(std::abs(bias), 3 / std::sqrt(30.0) * stated) << band;
    }
}

/// Glowing Lambert walls around a rough slab that loses nothing send unpolarized light of one radiance everywhere (theory
/// 3.9): the map of the degree of polarization stays black but for 1 % of its pixels, drawn by rays of the
/// eye or from the bins, though each draw of the slab is polarized and no cell is exact.
TEST(Gathered, NoiseIsNotShownAsPolarization) {
    GltfBuilder file;
    file.add_material("wall", {0.5, 0.5, 0.5}, 1);
    const int slab = file.add_material("slab", {1, 1, 1});
    file.json["materials"].back()["pbrMetallicRoughness"]["metallicFactor"] = 0;
    file.json["materials"].back()["pbrMetallicRoughness"]["roughnessFactor"] = std::sqrt(0.3);
    file.json["materials"].back()["extensions"] = {{"KHR_materials_ior", {{"ior", 1.5}}}};
    file.add_box("room", {-1, -1, -1}, {1, 1, 1}, true);
    file.add_box("slab", {-0.4f, -0.1f, -0.3f}, {0.4f, 0.1f, 0.3f}, false, slab);
    file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 0.01}}}}};
    file.add_node(
        {{"name", "above"}, {"camera", 0}, {"translation", {0.1, 0.35, 0.9}}, {"rotation", {-0.17, 0, 0, 0.985}}});
    const std::string folder = fresh_folder();
    write_text(folder + "/slab.gltf", file.text());
    const auto coloured = [&](const std::string& map) {
        const ScreenImage image = read_png(folder + "/" + map + ".png");
        int count = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            count += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2] > 6;
        return static_cast<double>(count) / (image.width * image.height);
    };
    for (const char* gather : {"on", "off"}) {
        report_of({"shot",      "slab.gltf", "--photons", "2e5",  "--camera", "above",    "--size",     "64x48",
                   "--samples", "16",        "--map",     "dolp", "--map",    "s1",       "--exposure", "8",
                   "--legend",  "off",       "--gather",  gather, "--out",    "{map}.png"},
                  folder);
        EXPECT_LE(coloured("dolp"), 0.01) << gather;
        EXPECT_GT(coloured("s1"), 0.1) << gather;  // what noise there is
    }
}

}  // namespace
}  // namespace brewster
