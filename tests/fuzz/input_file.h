#pragma once
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace brewster {

/// The fuzzer's bytes as a file of this process, for what reads files; gone with its owner.
class InputFile {
  public:
    InputFile(const std::string& ending, const std::uint8_t* data, std::size_t size)
        : path_((std::filesystem::temp_directory_path() / ("brewster-fuzz-" + std::to_string(getpid()) + ending))
                    .string()) {
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    }
    ~InputFile() { std::filesystem::remove(path_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace brewster
