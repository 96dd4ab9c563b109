#pragma once
#include <glm/vec3.hpp>

#include "bins/bin_settings.h"
#include "bins/snapshot.h"
#include "bins/tree.h"

namespace brewster {

/// Chooses the leaves of the trees of gloss afresh, for all fields together, and writes them down for the lookup.
/// S0 of a child is its parent's times its share of what came since the split; S1, S2, S3 follow S0 by the ratio of
/// their sums. `pending`, `photons`, `flux_per_weight` as in publish. `roots` comes back per chart of the tree.
GlossBins publish_gloss(const BinTree<4>& tree, const GlossFields& fields, const Tally<4>* pending,
                        std::uint64_t photons, glm::dvec3 flux_per_weight, const BinSettings& settings,
                        unsigned threads = 1);

}  // namespace brewster
