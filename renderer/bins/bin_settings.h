#pragma once
#include <cstddef>

namespace brewster {

/// How the bins adapt. The defaults are tuned on the canonical scenes (tests/bench/README.md).
struct BinSettings {
    std::size_t memory_bytes = std::size_t{1} << 30;  ///< of leaves' records and two snapshots
    double split_photons = 128;                       ///< effective photons a leaf must hold before it is tested
    double split_z_squared = 9;                       ///< squared deviation, in variances, that splits it
    double prune_lambda = 1.7;  ///< a split is published if its detail exceeds twice this times its noise
    bool join_corners = true;   ///< published cells that agree meet without a step
    int fixed_grid_log2 = -1;   ///< >= 0: 2^this by 2^this cells a chart, never split, never pruned (measurements)
    // Habits of the 1997 method, to compare with.
    bool constant_cells = false;    ///< published cells have no slopes
    bool half_differences = false;  ///< one cell a chart at first, split where its halves differ (half_difference.h)
};

}  // namespace brewster
