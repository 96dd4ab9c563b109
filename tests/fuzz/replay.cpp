// Any bytes as a script for the window, before a stage that does nothing: a sentence, or a script that is played, at
// least its first steps.
#include "app/replay.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "fuzz/input_file.h"
#include "fuzz/json_mutator.h"
#include "fuzz/promises.h"

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
    static Stage stage = idle_stage();
    const InputFile input(".json", data, size);
    try {
        Replay replay(input.path(), "/dev/null");
        constexpr int frames = 100;
        for (int frame = 0; frame < frames && replay.advance(stage); ++frame) {
            replay.presented(1.0, stage);
            promise(replay.patience() >= 0, "time goes on");
        }
    } catch (const Error& error) {
        promise_one_sentence(error.what());
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
    return brewster::mutate_json(data, size, most, seed, 4);
}
