#pragma once
#include "bins/snapshot.h"
#include "gather/eye_level.h"

namespace brewster {

/// Flux that enters the base per area, lux, and its standard error; polarized world, then unpolarized.
struct Entered {
    std::array<Rows<3>, 2> value, error;
};

/// Reads the bins of position for entries [first, end): the indirect light, and the direct light as well where the level
/// says so.
void read_entered(const Snapshot& bins, const Level& level, std::uint32_t first, std::uint32_t end, Entered& entered);

/// Ends entry i in the bins of gloss: adds what the interface sends back from there.
template <int components>
void add_gloss_of_bins(const Scene& scene, const Snapshot& bins, Level& level, std::uint32_t i);

}  // namespace brewster
