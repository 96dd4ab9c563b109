#pragma once
#include <glm/vec3.hpp>
#include <memory>

#include "bins/bin_settings.h"
#include "bins/snapshot.h"
#include "bins/tree.h"

namespace brewster {

/// Chooses the leaves of every chart afresh, for the direct and the indirect light apart, and writes them down for the
/// lookup. The splits to keep are chosen bottom-up (Pruning::choose). Top-down, a child's value is its parent's times
/// its share of what came since the split.
///
/// `fields`: what the tree's records hold. `pending`: tallies of the running batch, or null. `photons`: emitted in all.
/// `flux_per_weight`: per band, lumen of one unit of weight times the number of photons; where photons carry all bands
/// apart, that is the mean power of all lamps over the bands. The result is the same for any number of threads.
Snapshot publish(const BinTree<2>& tree, const EntryFields& fields, const Tally<2>* pending, std::uint64_t photons,
                 glm::dvec3 flux_per_weight, const BinSettings& settings, unsigned threads = 1);

}  // namespace brewster
