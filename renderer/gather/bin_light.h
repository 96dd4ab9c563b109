#pragma once
#include "bins/snapshot.h"
#include "gather/eye_level.h"

namespace brewster {

/// Flux that enters the base per area, lux, and its standard error; polarized world, then unpolarized.
struct Entered {
    std::array<Rows<3>, 2> value, error;
};

/// What the bins of position say of the light at entries [first, end), direct and indirect.
void read_all_entered(const Snapshot& bins, const Level& level, std::uint32_t first, std::uint32_t end,
                      Entered& entered);

/// The same without what rays will bring: direct light where shadow rays find it (reads_direct), indirect light where a
/// ray gathers it (gathers). Entries that doubt the bins leave to such rays what these know badly, and only that, and are
/// marked so. That goes by place and bins alone, so draws stay unbiased; it ends as photons make the bins exact.
void read_entered(const Snapshot& bins, std::uint32_t first, std::uint32_t end, Level& level, Entered& entered);

/// Ends entry i in the bins of gloss: adds to `light` what the interface sends back from there.
template <int components>
void add_gloss_of_bins(const Scene& scene, const Snapshot& bins, const Level& level, LevelLight& light,
                       std::uint32_t i);

}  // namespace brewster
