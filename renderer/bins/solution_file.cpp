#include "bins/solution_file.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/check.h"

namespace brewster {
namespace {

constexpr std::string_view magic = "BREWSTER";
constexpr std::size_t name_size = 8;
constexpr std::string_view last_block = "end";
constexpr const char* again = "trace the solution again";

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string padded(std::string_view name) {
    std::string all(name);
    all.resize(name_size, '\0');
    return all;
}

[[noreturn]] void fail(const std::string& path) {
    throw Error(std::string("it cannot be written: ") + std::strerror(errno), path,
                "choose a folder with room where you may write");
}

/// A file to write, closed and, unless it was kept, removed.
class OpenFile {
  public:
    OpenFile(std::string path, const std::string& wanted)
        : path_(std::move(path)),
          wanted_(wanted),
          descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0) fail(wanted_);
    }
    ~OpenFile() {
        if (descriptor_ >= 0) close(descriptor_);
        if (!kept_) unlink(path_.c_str());
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail(wanted_);
            bytes.remove_prefix(static_cast<std::size_t>(written));
        }
    }
    void keep_as(const std::string& name) {
        if (fsync(descriptor_) != 0) fail(wanted_);
        const int closed = close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || std::rename(path_.c_str(), name.c_str()) != 0) fail(wanted_);
        kept_ = true;
    }

  private:
    const std::string path_, wanted_;
    int descriptor_;
    bool kept_ = false;
};

}  // namespace

void SolutionWriter::add(const std::string& name, const ByteWriter& block) {
    BREWSTER_CHECK(name.size() <= name_size && name != last_block, name);
    blocks_.emplace_back(name, block.bytes());
}

void SolutionWriter::write(const std::string& path) const {
    OpenFile file(path + ".part", path);
    const auto write_block = [&](std::string_view name, std::string_view bytes) {
        ByteWriter head;
        head.put(static_cast<std::uint64_t>(bytes.size()));
        head.put(checksum(bytes));
        file.write(padded(name) + head.bytes());
        file.write(bytes);
    };
    ByteWriter version;
    version.put(solution_file_version);
    file.write(std::string(magic) + version.bytes());
    for (const auto& [name, bytes] : blocks_) write_block(name, bytes);
    write_block(last_block, {});
    file.keep_as(path);
}

SolutionReader::SolutionReader(const std::string& path) : path_(path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        throw Error("there is no such file", path, "name one that was saved with --save");
    std::ifstream stream(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    if (!stream) throw Error("it cannot be read", path, "check its permissions");

    std::string_view rest = bytes_;
    const auto take = [&](std::size_t size) {
        if (size > rest.size()) throw Error("it ends too early", path_, again);
        const std::string_view taken = rest.substr(0, size);
        rest.remove_prefix(size);
        return taken;
    };
    const auto take_number = [&]<class Number>(Number number) {
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
        return number;
    };
    if (rest.substr(0, magic.size()) != magic)
        throw Error("it is no saved solution", path, "name one that was saved with --save");
    take(magic.size());
    const std::uint32_t version = take_number(std::uint32_t{});
    if (version != solution_file_version)
        throw Error(
            "it has version " + std::to_string(version) + " instead of " + std::to_string(solution_file_version), path,
            "trace the solution again with this program");
    for (bool ended = false; !ended;) {
        const std::string_view name_bytes = take(name_size);
        const std::string name(name_bytes.substr(0, name_bytes.find_last_not_of('\0') + 1));
        const auto size = take_number(std::uint64_t{});
        const auto expected = take_number(std::uint32_t{});
        const std::string_view block = take(static_cast<std::size_t>(size));
        if (checksum(block) != expected) throw Error("it is damaged in its part \"" + name + "\"", path, again);
        ended = name == last_block;
        if (!ended) blocks_.emplace_back(name, block);
    }
    if (!rest.empty()) throw Error("it goes on behind its end", path, again);
}

ByteReader SolutionReader::block(const std::string& name) const {
    const auto found =
        std::find_if(blocks_.begin(), blocks_.end(), [&](const auto& each) { return each.first == name; });
    if (found == blocks_.end()) throw Error("its part \"" + name + "\" is missing", path_, again);
    return {found->second, path_};
}

}  // namespace brewster
