#pragma once
#include <cstdint>

namespace brewster {

inline constexpr std::uint64_t photons_per_block = 1024;  ///< what a worker takes at a time

/// The fixed sequence of batches: whole blocks, each batch a quarter longer than the one before. Trees change only at
/// their ends, so the sequence is part of what a solution is.
class BatchSequence {
  public:
    std::uint64_t begin() const { return begin_; }
    std::uint64_t end() const { return begin_ + blocks_ * photons_per_block; }
    void next() {
        begin_ = end();
        blocks_ += (blocks_ + 3) / 4;
    }

  private:
    std::uint64_t begin_ = 0;
    std::uint64_t blocks_ = 8;
};

}  // namespace brewster
