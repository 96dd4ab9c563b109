#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/byte_stream.h"

/// The file that a solution is kept in: a magic word, a version, then named blocks, each with its length and the CRC of
/// its bytes, and an empty block "end" that says that nothing is missing.
namespace brewster {

inline constexpr std::uint32_t solution_file_version = 2;

/// Collects blocks and writes them in one go.
class SolutionWriter {
  public:
    /// Names have at most 8 letters.
    void add(const std::string& name, const ByteWriter& block);

    /// Writes to a temporary name beside `path`, makes sure that the bytes are on the disk, then renames: whatever happens,
    /// there is the whole new file at `path` or what was there before. Throws Error where it cannot be written.
    void write(const std::string& path) const;

  private:
    std::vector<std::pair<std::string, std::string>> blocks_;
};

/// A file that was read and found whole. Throws Error in one sentence for one that is missing, foreign, of another
/// version, cut short or damaged.
class SolutionReader {
  public:
    explicit SolutionReader(const std::string& path);

    const std::string& path() const { return path_; }

    /// A block that must be there.
    ByteReader block(const std::string& name) const;

  private:
    std::string path_, bytes_;
    std::vector<std::pair<std::string, std::string_view>> blocks_;  // into bytes_
};

}  // namespace brewster
