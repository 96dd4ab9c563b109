#pragma once
#include <array>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

inline constexpr int world_count = 2;  ///< 0 polarized, 1 unpolarized

/// Where the emitted light went, per world and band, in quanta. emitted = absorbed + escaped + cut + corrected + roulette, exactly.
/// Where both worlds are the same only the first is kept, and of photons with one band only the first band.
struct Ledger {
    using Account = std::array<std::array<Wide, band_count>, world_count>;
    Account emitted{};
    Account absorbed{};   ///< by surfaces and by absorbing backs
    Account escaped{};    ///< left the scene
    Account cut{};        ///< stopped at the bounce limit, or sent below its facet by a shading normal
    Account corrected{};  ///< taken, or given, by the correction for shading normals
    Account roulette{};   ///< lost to roulette less what its survivors gained: zero on average

    void add(const Ledger& other);
    bool balances() const;
};

}  // namespace brewster
