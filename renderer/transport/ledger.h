#pragma once
#include <array>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

/// Where the emitted light went, per band, in quanta. emitted = absorbed + escaped + cut + roulette, exactly.
struct Ledger {
    using Account = std::array<Wide, band_count>;
    Account emitted{};
    Account absorbed{};  ///< by bases and by absorbing backs
    Account escaped{};   ///< left the scene
    Account cut{};       ///< stopped at the bounce limit
    Account roulette{};  ///< lost to roulette less what its survivors gained: zero on average

    void add(const Ledger& other);
    bool balances() const;
};

}  // namespace brewster
