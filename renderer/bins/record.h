#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

inline constexpr int replica_count = 8;  ///< photon index mod 8; their spread gives the error bars

/// Where a number stands in the two records of a leaf. Channels of the estimate: bands of the direct, then of the
/// indirect light. Cell coordinates x_a of [-1, 1].
template <int D>
struct RecordLayout {
    static constexpr int channels = 2 * band_count;
    static constexpr int estimate_stride = D + 2;  ///< per channel: sum w, sum w x_a, sum w^2
    static constexpr int estimate_size = channels * estimate_stride;
    static constexpr int pair_count = D * (D - 1) / 2;

    // The test record, of the band mean: sum w^2, then per axis sum w x, sum w (3 x^2 - 1)/2, sum w sign x, then per
    // pair of axes sum w sign x_a sign x_b, then sum w of each replica.
    static constexpr int squares = 0;
    static constexpr int moments = 1;
    static constexpr int legendre = moments + D;
    static constexpr int signs = legendre + D;
    static constexpr int products = signs + D;
    static constexpr int replicas = products + pair_count;
    static constexpr int test_size = replicas + replica_count;
};

/// Sums of one cell over everything that landed in it since it came to be.
template <int D>
struct CellSums {
    std::array<Wide, RecordLayout<D>::estimate_size> estimate{};
    std::array<Wide, RecordLayout<D>::test_size> test{};
};

/// What one thread has tallied since the last hand-over: one row of each record a leaf.
template <int D>
class Tally {
  public:
    using Layout = RecordLayout<D>;

    void resize(std::size_t leaves) {
        estimate_.resize(leaves * Layout::estimate_size);
        test_.resize(leaves * Layout::test_size);
    }
    std::size_t leaves() const { return estimate_.size() / Layout::estimate_size; }

    Quanta* estimate(std::uint32_t leaf) { return &estimate_[std::size_t{leaf} * Layout::estimate_size]; }
    Quanta* test(std::uint32_t leaf) { return &test_[std::size_t{leaf} * Layout::test_size]; }
    const Quanta* estimate(std::uint32_t leaf) const { return &estimate_[std::size_t{leaf} * Layout::estimate_size]; }
    const Quanta* test(std::uint32_t leaf) const { return &test_[std::size_t{leaf} * Layout::test_size]; }

    /// Moves the other's sums into this tally and leaves it at zero.
    void take(Tally& other) {
        drain(other.estimate_, estimate_);
        drain(other.test_, test_);
    }

  private:
    static void drain(std::vector<Quanta>& from, std::vector<Quanta>& to) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            to[i] += from[i];
            from[i] = 0;
        }
    }

    std::vector<Quanta> estimate_, test_;
};

}  // namespace brewster
