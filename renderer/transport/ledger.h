#pragma once
#include <array>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

inline constexpr int world_count = 2;  ///< 0 polarized, 1 unpolarized

/// Where the emitted light went, per world and band, in quanta: emitted = absorbed + escaped + cut + roulette + shading +
/// capped, exactly; the last two are zero where all meshes are flat. Where both worlds are the same only the first is
/// kept, and of photons with one band only the first band.
struct Ledger {
    using Account = std::array<std::array<Wide, band_count>, world_count>;
    Account emitted{};
    Account absorbed{};  ///< by surfaces and by absorbing backs
    Account escaped{};   ///< left the scene
    Account cut{};       ///< stopped at the bounce limit, or behind the facet or the shading normal of a smooth mesh
    Account roulette{};  ///< lost to roulette less what its survivors gained: zero on average
    Account shading{};   ///< lost to the correction for shading normals (theory 4.1) less what it gave
    Account capped{};    ///< of what the correction would have given, taken by its cap

    void add(const Ledger& other);
    bool balances() const;
};

}  // namespace brewster
