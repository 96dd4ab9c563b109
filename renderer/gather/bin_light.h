#pragma once
#include "bins/snapshot.h"
#include "gather/eye_level.h"

namespace brewster {

/// Flux that enters the base per area, lux, and its standard error; polarized world, then unpolarized.
struct Entered {
    std::array<Rows<3>, 2> value, error;
};

/// Whether the bins of position tell the direct light: always, or where the level says so.
enum class DirectLight { always, where_wanted };

/// Reads the bins of position for entries [first, end): the indirect light, and the direct light as asked.
void read_entered(const Snapshot& bins, const Level& level, std::uint32_t first, std::uint32_t end,
                  DirectLight direct_light, Entered& entered);

/// Ends entry i in the bins of gloss: adds to `light` what the interface sends back from there.
template <int components>
void add_gloss_of_bins(const Scene& scene, const Snapshot& bins, const Level& level, LevelLight& light,
                       std::uint32_t i);

}  // namespace brewster
