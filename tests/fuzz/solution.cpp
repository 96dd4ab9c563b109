// Any bytes as a saved solution: a sentence, or an engine that goes on from it and keeps its accounts. Checksums are made
// right after each change, so that what lies behind them is read, too.
#include <zlib.h>

#include <cstring>
#include <memory>
#include <string>

#include "base/error.h"
#include "engine/engine.h"
#include "engine/saved_settings.h"
#include "fuzz/input_file.h"
#include "fuzz/promises.h"
#include "scene/mutations.h"
#include "scene/scene.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t file_head = 12, block_head = 20;  // magic, version; name, length, checksum

// Makes the checksums of all blocks right, as far as their lengths lead.
void mend_checksums(std::uint8_t* data, std::size_t size) {
    for (std::size_t at = file_head; at + block_head <= size;) {
        std::uint64_t length = 0;
        std::memcpy(&length, data + at + 8, sizeof length);
        if (length > size - at - block_head) return;
        const auto sum = static_cast<std::uint32_t>(crc32_z(0, data + at + block_head, length));
        std::memcpy(data + at + 16, &sum, sizeof sum);
        at += block_head + length;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    static const auto scene = std::make_shared<const Scene>(read_scene_text(whole_file().text(), "whole"));
    const InputFile input(".bins", data, size);
    try {
        const SolutionReader file(input.path());
        SavedSettings settings = saved_settings(file);
        settings.engine.threads = 1;
        settings.engine.bins.memory_bytes = std::min(settings.engine.bins.memory_bytes, std::size_t{1} << 24);
        Engine engine(scene, settings.engine);
        engine.load(file);
        engine.start({engine.progress().photons + 100, {}, {}});
        engine.wait();
        promise(!engine.digest().empty(), "a solution has a digest");
    } catch (const Error& error) {
        promise_one_sentence(error.what());
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
    const std::size_t changed = LLVMFuzzerMutate(data, size, most);
    if (seed % 8 != 0) mend_checksums(data, changed);
    return changed;
}
