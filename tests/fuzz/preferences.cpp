// Any bytes as the file of preferences: taken or set aside with a sentence, and within bounds either way.
#include "app/preferences.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace brewster;
    namespace fs = std::filesystem;
    static const fs::path folder = fs::temp_directory_path() / ("brewster-fuzz-" + std::to_string(getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "settings.json", std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    std::string complaint;
    const Preferences preferences = read_preferences(folder.string(), complaint);
    promise(preferences.text_scale >= 0.8f && preferences.text_scale <= 2.0f, "text can be read");
    promise(preferences.recent_files.size() <= 12, "few files are recent");
    promise(complaint.empty() == fs::exists(folder / "settings.json"), "what is not understood is set aside");
    fs::remove_all(folder);
    return 0;
}
