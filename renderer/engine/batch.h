#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

namespace brewster {

inline constexpr std::uint64_t photons_per_block = 1024;
inline constexpr std::uint64_t most_blocks_taken = 8;  ///< by a worker at a time: a few milliseconds

/// The fixed sequence of batches: whole blocks, each batch a quarter longer than the one before, up to 2^22 photons, so
/// that 64 bits hold a batch's sums even where a photon comes by a thousand times. Trees change only at the ends of
/// batches, so the sequence is part of what a solution is.
class BatchSequence {
  public:
    BatchSequence() = default;
    /// Of its own first batch and growth, one part in so many.
    BatchSequence(std::uint64_t first_blocks, std::uint64_t part) : blocks_(first_blocks), part_(part) {}

    std::uint64_t begin() const { return begin_; }
    std::uint64_t end() const { return begin_ + blocks_ * photons_per_block; }
    void next() {
        begin_ = end();
        blocks_ = std::min(blocks_ + (blocks_ + part_ - 1) / part_, most_blocks);
    }

    /// The batch that begins there; none does at most places.
    static std::optional<BatchSequence> beginning_at(std::uint64_t photon) {
        BatchSequence batch;
        while (batch.begin() < photon) batch.next();
        return batch.begin() == photon ? std::optional(batch) : std::nullopt;
    }

  private:
    static constexpr std::uint64_t most_blocks = 4096;
    std::uint64_t begin_ = 0;
    std::uint64_t blocks_ = 8, part_ = 4;
};

}  // namespace brewster
