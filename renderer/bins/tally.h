#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_stream.h"
#include "base/zeroed_array.h"
#include "bins/record.h"

namespace brewster {

/// What one thread has tallied since the last hand-over: one row of each record a leaf. Rows that nothing was filed in
/// are known, so that taking the sums costs as much as was filed, however many leaves there are.
template <int D>
class Tally {
  public:
    explicit Tally(const RecordLayout<D>& layout = {})
        : estimate_size_(static_cast<std::size_t>(layout.estimate_size())),
          test_size_(static_cast<std::size_t>(layout.test_size())) {}

    void resize(std::size_t leaves) {
        estimates_.resize(leaves * estimate_size_);
        tests_.resize(leaves * test_size_);
        touched_.resize(leaves);
    }
    std::size_t leaves() const { return touched_.size(); }
    std::size_t estimate_size() const { return estimate_size_; }
    std::size_t test_size() const { return test_size_; }

    const Quanta* estimate(std::uint32_t leaf) const { return &estimates_[leaf * estimate_size_]; }
    const Quanta* test(std::uint32_t leaf) const { return &tests_[leaf * test_size_]; }
    /// False: both rows are zero.
    bool touched(std::uint32_t leaf) const { return touched_[leaf] != 0; }

    struct Rows {
        Quanta *estimate, *test;
    };
    /// To file into.
    Rows touch(std::uint32_t leaf) {
        touched_[leaf] = 1;
        return {&estimates_[leaf * estimate_size_], &tests_[leaf * test_size_]};
    }

    /// Adds the rows of a leaf to sums of their sizes and leaves them at zero.
    template <class Sum>
    void move(std::uint32_t leaf, Sum* estimate, Sum* test) {
        move_row(&estimates_[leaf * estimate_size_], estimate_size_, estimate);
        move_row(&tests_[leaf * test_size_], test_size_, test);
        touched_[leaf] = 0;
    }

    /// Adds others of as many leaves to this tally and leaves them at zero, on so many threads.
    void take(std::span<Tally* const> others, unsigned threads);

    void write(ByteWriter& file) const {
        file.put_all(estimates_.data(), estimates_.size());
        file.put_all(tests_.data(), tests_.size());
    }
    /// Sums of as many leaves as the tally has room for.
    void read(ByteReader& file) {
        file.get_all(estimates_.data(), estimates_.size());
        file.get_all(tests_.data(), tests_.size());
        touched_.assign(touched_.size(), 1);
    }

  private:
    template <class Sum>
    static void move_row(Quanta* from, std::size_t size, Sum* to) {
        for (std::size_t i = 0; i < size; ++i) {
            to[i] += from[i];
            from[i] = 0;
        }
    }

    std::size_t estimate_size_, test_size_;
    ZeroedArray<Quanta> estimates_, tests_;
    std::vector<std::uint8_t> touched_;  // per leaf
};

extern template class Tally<2>;
extern template class Tally<4>;

}  // namespace brewster
