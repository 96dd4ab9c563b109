#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "bins/record.h"

namespace brewster {

/// Spread of the replicas over sum w^2 of one cell: 1 for independent photons that deposit once.
struct Spread {
    std::array<double, replica_count> replicas{};
    double squares = 0;

    void add(const Spread& other) {
        for (std::size_t r = 0; r < replicas.size(); ++r) replicas[r] += other.replicas[r];
        squares += other.squares;
    }
    double variance() const {
        double mean = 0, sum = 0;
        for (const double r : replicas) mean += r / replica_count;
        for (const double r : replicas) sum += (r - mean) * (r - mean);
        return sum * replica_count / (replica_count - 1.0);
    }
};

/// Squared error of leaves over their noise. Pruning stops where structure drowns in noise, so about as much structure as
/// noise is left under the leaves, another part with every seed. The tally tree knows how much: the details of the
/// splits that were not published, less their noise.
struct Excess {
    double structure = 0, noise = 0;  ///< squared density x area, weighted by the bands' importance
    double leaves = 0;

    /// Few leaves know it badly (a leaf's own estimate has a standard deviation of 4.5), so a chart leans on its scene,
    /// both lean on there being none, and only what stands out by half a standard deviation counts.
    double inflation(const Excess& scene) const {
        constexpr double deviation_of_one = 4.5, lean_on_scene = 64, lean_on_none = 16;
        if (noise <= 0 || scene.noise <= 0) return 1;
        const double lean = std::min(lean_on_scene, scene.leaves);
        const double sum = leaves * structure / noise + lean * scene.structure / scene.noise;
        const double chance = 0.5 * deviation_of_one * std::sqrt(leaves + lean);
        return 1 + std::max(0.0, (sum - chance) / (leaves + lean + lean_on_none));
    }
};

}  // namespace brewster
