// Any bytes as a script for the window, before a stage that does nothing: a sentence, or a script that is played, at
// least its first steps.
#include "app/replay.h"

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "fuzz/json_mutator.h"
#include "fuzz/promises.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

brewster::Stage idle_stage() {
    const auto nothing = [](const std::string&) {};
    brewster::Stage stage;
    stage.input = [](const brewster::InputEvent&) {};
    stage.type = stage.set = stage.open = stage.save = stage.save_solution = stage.capture = nothing;
    stage.resize = [](int, int) {};
    stage.minimise = stage.make_flat = [](bool) {};
    stage.quit = [] {};
    stage.state = [] {
        return nlohmann::json{{"picture", {640, 480}}, {"saving", false}, {"photons", 1000},     {"bins", true},
                              {"generation", 1},       {"stale", false},  {"milliseconds", 1.0}, {"words", ""}};
    };
    return stage;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    static const std::string path =
        (std::filesystem::temp_directory_path() / ("brewster-fuzz-" + std::to_string(getpid()) + ".json")).string();
    static Stage stage = idle_stage();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    try {
        Replay replay(path, "/dev/null");
        constexpr int frames = 100;
        for (int frame = 0; frame < frames && replay.advance(stage); ++frame) {
            replay.presented(1.0, stage);
            promise(replay.patience() >= 0, "time goes on");
        }
    } catch (const Error& error) {
        promise(std::string(error.what()).find('\n') == std::string::npos, "an error is one sentence");
    }
    std::filesystem::remove(path);
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
    if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
    const std::string changed = brewster::with_changed_json(std::string(reinterpret_cast<char*>(data), size), seed / 4);
    if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, changed.data(), changed.size());
    return changed.size();
}
