#pragma once
#include <array>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

/// Where the emitted light went, per band, in quanta. emitted = absorbed + escaped + cut + roulette + shading + capped,
/// exactly; the last two are zero where all meshes are flat.
struct Ledger {
    using Account = std::array<Wide, band_count>;
    Account emitted{};
    Account absorbed{};  ///< by bases and by absorbing backs
    Account escaped{};   ///< left the scene
    Account cut{};       ///< stopped at the bounce limit, or behind the facet or the shading normal of a smooth mesh
    Account roulette{};  ///< lost to roulette less what its survivors gained: zero on average
    Account shading{};   ///< lost to the correction for shading normals (theory 4.1) less what it gave
    Account capped{};    ///< of that correction, what its cap took

    void add(const Ledger& other);
    bool balances() const;
};

}  // namespace brewster
