#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace brewster {

/// What the tally tree below a published leaf says of it: squared density x area, weighted by the bands' importance.
struct LeafExcess {
    double structure = 0;  ///< details of the splits that were not published, less their noise
    double noise = 0;      ///< of the leaf's own fit, were its photons independent; 0: nothing is known
};

/// Pruning stops where structure drowns in noise, so about as much structure as noise is left under the leaves, another
/// part with every seed. For each leaf its mean squared structure over its noise, at least 0. `chart_begin`: where in
/// `leaves` each chart begins, and their end.
///
/// A leaf knows its own only to +- 4.5, so it leans on its chart, and that on the scene and on there being none; of each
/// only what stands out of chance counts. The weights were chosen on the Cornell box, 1e5 photons, for bars of this alone;
/// cells over position that share corners need less of it (tests/bench/README.md).
std::vector<double> hidden_structure(std::span<const LeafExcess> leaves, std::span<const std::size_t> chart_begin);

}  // namespace brewster
