#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/process.h"
#include "display/maps.h"
#include "image/png.h"

/// The command line as a person or a script meets it: the real program, its exit codes, what it prints where.
namespace brewster {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string cornell_box = BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf";

ProcessResult brewster(std::vector<std::string> arguments, const std::string& folder = {}) {
    arguments.insert(arguments.begin(), brewster_program());
    ProcessSetting setting;
    setting.folder = folder;
    return run_process(arguments, setting);
}

/// Expects a failure in one sentence, on standard error only, that holds `part`.
void expect_sentence(const ProcessResult& result, int exit_code, const std::string& part) {
    EXPECT_EQ(result.exit_code, exit_code) << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.errors.rfind("brewster: ", 0), 0u) << result.errors;
    EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
    if (exit_code == 1) {
        EXPECT_EQ(result.errors.find('\n'), result.errors.size() - 1) << result.errors;
    }
}

TEST(Program, VersionAndHelpGoToStandardOutput) {
    for (const char* option : {"--version", "--help"}) {
        const ProcessResult result = brewster({option});
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.errors, "");
        EXPECT_NE(result.output.find("brewster"), std::string::npos);
    }
}

TEST(Program, UsageErrorsExitWithTwo) {
    expect_sentence(brewster({"solve", cornell_box, "--photons", "1.5"}), 2, "--photons");
    expect_sentence(brewster({"solve", cornell_box, "--photons", "1e30"}), 2, "1e30");
    expect_sentence(brewster({"solve"}), 2, "scene");
    expect_sentence(brewster({"sovle", cornell_box}), 2, "did you mean 'solve'");
    expect_sentence(brewster({"shot", cornell_box, "--siez", "10x10"}), 2, "did you mean '--size'");
}

TEST(Program, SolveReportsOneJsonObject) {
    const ProcessResult result = brewster({"solve", cornell_box, "--photons", "20000", "--threads", "2", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    const json report = json::parse(result.output);
    EXPECT_EQ(report["photons"], 20000);
    EXPECT_EQ(report["photons_by_thread"].size(), 2u);
    EXPECT_EQ(report["ledger"]["balances"], true);
    EXPECT_EQ(report["trouble"], 0);
    EXPECT_GT(report["bounces"], 20000);
    EXPECT_GT(report["published_leaves"], 0);
    EXPECT_GT(report["relative_error"], 0.0);
    EXPECT_GT(report["first_snapshot_ms"], 0.0);
    EXPECT_FALSE(report["digest"].get<std::string>().empty());
}

TEST(Program, LedgerAddsUpAsWritten) {
    const ProcessResult result = brewster({"solve", cornell_box, "--photons", "5000", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json ledger = json::parse(result.output)["ledger"];
    for (std::size_t band = 0; band < 3; ++band) {
        // 5000 photons of weight about 1 stay far below 2^63 quanta.
        const auto quanta = [&](const char* account) { return std::stoll(ledger[account][band].get<std::string>()); };
        EXPECT_GT(quanta("emitted"), 0);
        EXPECT_EQ(quanta("emitted"), quanta("absorbed") + quanta("escaped") + quanta("cut") + quanta("roulette"));
    }
}

TEST(Program, SolveSummarisesForPeople) {
    const ProcessResult result = brewster({"solve", cornell_box, "--photons", "2e4"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.output.find("20 k photons"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("balances exactly"), std::string::npos) << result.output;
}

TEST(Program, SecondsStopTheRun) {
    const ProcessResult result = brewster({"solve", cornell_box, "--seconds", "0.3", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const double seconds = json::parse(result.output)["seconds"];
    EXPECT_GE(seconds, 0.3);
    EXPECT_LT(seconds, 3.0) << "a busy machine may be late, but not ten times";
}

TEST(Program, CtrlCEndsWithThePhotonsThereAre) {
    ProcessSetting setting;
    setting.signal = SIGINT;
    setting.signal_delay_ms = 1500;
    const ProcessResult result =
        run_process({brewster_program(), "solve", cornell_box, "--photons", "1e12", "--json"}, setting);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_GT(report["photons"], 0);
    EXPECT_LT(report["photons"], 1'000'000'000'000);
    EXPECT_EQ(report["ledger"]["balances"], true);
    EXPECT_EQ(result.errors.find('\r'), std::string::npos) << "a progress bar without a terminal";
    EXPECT_NE(result.errors.find("going on with " + report["photons"].dump() + " photons"), std::string::npos)
        << result.errors;
}

TEST(Program, ShotWritesEveryCameraWhereAskedFor) {
    const std::string folder = fresh_folder();
    const ProcessResult result = brewster({"shot", cornell_box, "--photons", "2e4", "--samples", "2", "--size", "40x30",
                                           "--camera", "all", "--out", "a new/folder/{camera}-{map}.png", "--json"},
                                          folder);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    const json report = json::parse(result.output);
    ASSERT_EQ(report["pictures"].size(), 3u);
    EXPECT_EQ(report["pictures"][0]["path"], "a new/folder/front-radiance.png");
    for (const json& picture : report["pictures"]) {
        EXPECT_GT(fs::file_size(folder + "/" + picture["path"].get<std::string>()), 100u);
    }
    EXPECT_EQ(report["solve"]["photons"], 20000);
}

// Only pictures that look straight through glass say so.
TEST(Program, ShotSaysWhatItLooksStraightThrough) {
    const std::string folder = fresh_folder();
    for (const std::string gather : {"on", "off"}) {
        const ProcessResult result =
            brewster({"shot", BREWSTER_SOURCE_DIR "/assets/scenes/shop-window.gltf", "--photons", "5000", "--size",
                      "16x12", "--samples", "1", "--camera", "straight", "--gather", gather, "--out", "{camera}.png"},
                     folder);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        EXPECT_EQ(result.errors.find("straight through \"pane\"") != std::string::npos, gather == "off")
            << result.errors;
    }
}

TEST(Program, ShotComparesWithItself) {
    const std::string folder = fresh_folder();
    const std::vector<std::string> shot = {"shot",   cornell_box, "--photons", "2e4",   "--samples", "2",
                                           "--size", "24x24",     "--camera",  "front", "--out"};
    for (const char* name : {"one.exr", "two.exr"}) {
        std::vector<std::string> arguments = shot;
        arguments.emplace_back(name);
        const ProcessResult result = brewster(arguments, folder);
        ASSERT_EQ(result.exit_code, 0) << result.errors;
        EXPECT_EQ(result.output, std::string(name) + "\n");
    }
    const ProcessResult result = brewster({"compare", "one.exr", "two.exr", "--json"}, folder);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_EQ(report["pixels"], 24 * 24);
    for (const char* band : {"R", "G", "B"}) {
        EXPECT_EQ(report["components"]["S0"][band]["rmse"], 0.0) << "the same seed draws the same picture";
        EXPECT_GT(report["components"]["S0"][band]["mean"], 0.0);
    }
}

// The file holds the linear light and the exposure: developed, it is the picture that was drawn, but for the rounding of
// a mean and its variance to one code.
TEST(Program, DevelopedFilesShowTheSamePicture) {
    const std::string folder = fresh_folder();
    const std::string spheres = BREWSTER_SOURCE_DIR "/assets/scenes/spheres.gltf";
    const std::string view = "eye=0.2,1.2,3 target=0,0.5,0 fov=50 size=64x48 samples=2";
    const auto shot = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"shot", spheres, "--photons", "1e4", "--view", view};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = brewster(arguments, folder);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
    };
    shot({"--ground-truth", "--out", "light.exr"});
    shot({"--map", "all", "--out", "shot-{map}.png"});
    const ProcessResult developed =
        brewster({"develop", "light.exr", "--map", "all", "--out", "file-{map}.png", "--json"}, folder);
    ASSERT_EQ(developed.exit_code, 0) << developed.errors;
    const json report = json::parse(developed.output);
    EXPECT_EQ(report["pictures"].size(), map_descriptions.size() - 2);
    for (const json& picture : report["pictures"]) {
        const std::string map = picture["map"];
        const ScreenImage from_shot = read_png(folder + "/shot-" + map + ".png");
        const ScreenImage from_file = read_png(folder + "/file-" + map + ".png");
        ASSERT_EQ(from_shot.rgba.size(), from_file.rgba.size());
        int worst = 0;
        for (std::size_t i = 0; i < from_shot.rgba.size(); ++i)
            worst = std::max(worst, std::abs(from_shot.rgba[i] - from_file.rgba[i]));
        EXPECT_LE(worst, map == "error" ? 3 : 1) << map;
    }
    EXPECT_GT(report["bands"]["G"]["mean"][0], 0.0);
    const json cameras = json::parse(read_text(folder + "/cameras.json"));
    EXPECT_EQ(cameras["cameras"][0]["name"], "view");
    EXPECT_EQ(cameras["cameras"][0]["width"], 64);
    expect_sentence(brewster({"develop", "light.exr", "--map", "bins"}, folder), 1, "brewster shot");
    expect_sentence(brewster({"shot", spheres, "--view", "map=heat"}, folder), 2, "heat");
}

/// Seconds are of photons and draws together; a target is of both errors.
TEST(Program, ShotDividesItsTimeBetweenPhotonsAndDraws) {
    const std::string folder = fresh_folder();
    const auto report = [&](const std::vector<std::string>& stop) {
        std::vector<std::string> arguments = {"shot",  cornell_box,    "--size", "32x32",     "--camera",
                                              "front", "--camera",     "low",    "--threads", "2",
                                              "--out", "{camera}.exr", "--json"};
        arguments.insert(arguments.end(), stop.begin(), stop.end());
        const ProcessResult result = brewster(arguments, folder);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        return json::parse(result.output);
    };
    const json timed = report({"--seconds", "0.6"});
    const double tracing = timed["solve"]["seconds"], drawing = timed["gather"]["seconds"];
    EXPECT_GT(tracing, 0.05);
    EXPECT_GT(drawing, 0);
    EXPECT_LT(tracing + drawing, 0.6 + 2.0);  // blocks and batches under way are finished; sanitizers are slow
    const auto error = [](const json& of) {
        const json& errors = of["gather"]["relative_error"];
        return std::hypot(errors["draws"].get<double>(), errors["bins"].get<double>());
    };
    const json rough = report({"--target-error", "0.2"}), fine = report({"--target-error", "0.05"});
    EXPECT_LE(error(fine), 0.05);
    EXPECT_LE(error(rough), 0.2);
    EXPECT_LT(rough["gather"]["draws"], fine["gather"]["draws"]);
    // Photons that are asked for are not passed, and draws neither.
    const json few = report({"--seconds", "30", "--photons", "2e4", "--samples", "8"});
    EXPECT_EQ(few["solve"]["photons"], 20000);
    EXPECT_EQ(few["gather"]["draws"], 8.0);
}

TEST(Program, CompareLooksAtRegionsAndBlocksAndDrawsTheDifference) {
    const std::string folder = fresh_folder();
    for (const char* seed : {"1", "2"}) {
        const ProcessResult shot =
            brewster({"shot", cornell_box, "--photons", "2e4", "--samples", "2", "--size", "48x48", "--camera", "front",
                      "--seed", seed, "--out", std::string(seed) + ".exr"},
                     folder);
        ASSERT_EQ(shot.exit_code, 0) << shot.errors;
    }
    const auto report = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"compare", "1.exr", "2.exr", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = brewster(arguments, folder);
        EXPECT_EQ(result.exit_code, 0) << result.errors;
        return json::parse(result.output);
    };
    const json whole = report({"--out", "difference.png"}), blocks = report({"--block", "8", "--out", "d.exr"});
    const json floor = report({"--scene", cornell_box, "--camera", "front", "--region", "floor"});
    EXPECT_EQ(whole["pixels"], 48 * 48);
    EXPECT_EQ(blocks["pixels"], 6 * 6);
    EXPECT_GT(floor["pixels"], 48 * 48 / 20);
    EXPECT_LT(floor["pixels"], 48 * 48 / 3);
    const auto rmse = [](const json& of) { return of["components"]["S0"]["R"]["rmse"].get<double>(); };
    EXPECT_LT(rmse(blocks), rmse(whole));
    EXPECT_GT(fs::file_size(folder + "/difference.png"), 100u);
    EXPECT_GT(fs::file_size(folder + "/d.exr"), 100u);
    expect_sentence(
        brewster({"compare", "1.exr", "2.exr", "--scene", cornell_box, "--camera", "front", "--region", "flor"},
                 folder),
        1, "floor");
    expect_sentence(brewster({"compare", "1.exr", "2.exr", "--out", "difference.jpg"}, folder), 1, ".png");
    EXPECT_EQ(brewster({"compare", "1.exr", "2.exr", "--region", "floor"}, folder).exit_code, 2);
}

TEST(Program, ReferenceWritesStokesWithVariances) {
    const std::string folder = fresh_folder();
    const ProcessResult result = brewster({"reference", cornell_box, "--camera", "front", "--size", "24x24", "--spp",
                                           "16", "--out", "deep/ref.exr", "--json"},
                                          folder);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_EQ(report["samples"], 16);
    EXPECT_EQ(report["camera"], "front");
    EXPECT_GT(report["seconds"], 0.0);
    // The box's mean radiance by another renderer; 576 pixels of 16 samples know it to a few per cent.
    EXPECT_NEAR(report["mean_radiance"][0].get<double>(), 0.18652,
                5 * report["mean_radiance_standard_error"][0].get<double>());
    const ProcessResult compare = brewster({"compare", "deep/ref.exr", "deep/ref.exr", "--json"}, folder);
    const json components = json::parse(compare.output)["components"];
    for (const char* component : {"S0", "S1", "S2", "S3"}) EXPECT_TRUE(components.contains(component));
    expect_sentence(brewster({"reference", cornell_box, "--out", "ref.png"}, folder), 1, ".exr");
    expect_sentence(brewster({"reference", cornell_box, "--camera", "frnt"}, folder), 1, "front");
}

TEST(Program, UnknownCameraIsSuggested) {
    const ProcessResult result = brewster({"shot", cornell_box, "--camera", "frnt", "--photons", "1e7"});
    expect_sentence(result, 1, "did you mean 'front'");
    EXPECT_NE(result.errors.find("front, inside, low"), std::string::npos) << result.errors;
}

TEST(Program, PicturesOfOneNameAreRefusedBeforeTheWork) {
    const ProcessResult result =
        brewster({"shot", cornell_box, "--photons", "1e7", "--out", "one.png"}, fresh_folder());
    expect_sentence(result, 1, "several pictures");
}

TEST(Program, UnwritableFolderIsRefusedBeforeTheWork) {
    const std::string folder = fresh_folder();
    write_text(folder + "/file", "in the way");
    const ProcessResult result =
        brewster({"shot", cornell_box, "--photons", "1e7", "--out", "file/{camera}.png"}, folder);
    expect_sentence(result, 1, "file");
    fs::create_directories(folder + "/front.png");
    expect_sentence(brewster({"shot", cornell_box, "--photons", "1e7", "--out", "{camera}.png"}, folder), 1,
                    "front.png");
}

TEST(Program, MissingAndBrokenFilesAreNamed) {
    const std::string folder = fresh_folder();
    expect_sentence(brewster({"solve", "no such.gltf"}, folder), 1, "no such.gltf");
    expect_sentence(brewster({"info", "no such.gltf"}, folder), 1, "no such.gltf");
    expect_sentence(brewster({"no such.gltf", "--headless"}, folder), 1, "no such.gltf");
    expect_sentence(brewster({"compare", "a.exr", "b.exr"}, folder), 1, "a.exr");
    write_text(folder + "/broken file.gltf", "{");
    expect_sentence(brewster({"solve", "broken file.gltf"}, folder), 1, "broken file.gltf");
}

TEST(Program, PathsMayHoldSpaces) {
    const std::string folder = fresh_folder();
    fs::copy_file(cornell_box, folder + "/my box.gltf");
    const ProcessResult result = brewster({"info", "my box.gltf", "--json"}, folder);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_EQ(report["scene"], "my box");
    EXPECT_EQ(report["cameras"].size(), 3u);
    EXPECT_EQ(report["lamps"].size(), 1u);
}

TEST(Program, InfoNamesWhatIsThere) {
    const ProcessResult result = brewster({"info", cornell_box});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    for (const char* name : {"white", "red", "green", "lamp", "front", "inside", "low", "floor", "tall", " lm"}) {
        EXPECT_NE(result.output.find(name), std::string::npos) << name << " in\n" << result.output;
    }
}

TEST(Program, FullDiskIsAFailure) {
    const ProcessResult result =
        run_process({"/bin/sh", "-c", "exec \"$0\" info \"$1\" >/dev/full", brewster_program(), cornell_box});
    expect_sentence(result, 1, "standard output");
}

TEST(Program, WithoutADisplayPicturesAreWrittenAndSaid) {
    const std::string folder = fresh_folder();
    ProcessSetting setting;
    setting.folder = folder;
    setting.without = {"DISPLAY"};
    const ProcessResult result = run_process({brewster_program(), "--photons", "2e4", "--seconds", "1"}, setting);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.errors.find("DISPLAY"), std::string::npos) << result.errors;
    for (const char* camera : {"front", "inside", "low"}) {
        EXPECT_TRUE(fs::exists(folder + "/pictures/" + camera + ".png")) << camera;
        EXPECT_NE(result.output.find(std::string("pictures/") + camera + ".png"), std::string::npos) << result.output;
    }
}

}  // namespace
}  // namespace brewster
