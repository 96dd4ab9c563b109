#pragma once
#include <array>

#include "base/rows.h"
#include "scene/bsdf.h"
#include "transport/ledger.h"
#include "transport/path.h"

namespace brewster::transport {

/// What one photon, or a batch of them, moved between the accounts of the ledger: in quanta of the powers, so that what
/// an event took is what was before less what was after, and the accounts add up exactly.
template <class Real>
class Books {
  public:
    using Account = Ledger::Account Ledger::*;

    /// All the light of the photons of `mask` goes to the account.
    template <int components, int bands>
    void take(Account account, const MaskOf<Real>& mask, const PhotonLight<Real, components, bands>& light) {
        if (!any_of(mask)) return;
        for (int world = 0; world < PhotonLight<Real, components, bands>::worlds; ++world)
            for (int band = 0; band < bands; ++band) add(account, world, band, mask, light.power(world, band));
    }
    /// What an event took of the photons of `mask`.
    template <int components, int bands>
    void take(Account account, const MaskOf<Real>& mask, const PhotonLight<Real, components, bands>& before,
              const PhotonLight<Real, components, bands>& after) {
        if (!any_of(mask)) return;
        for (int world = 0; world < PhotonLight<Real, components, bands>::worlds; ++world)
            for (int band = 0; band < bands; ++band)
                move(account, world, band, mask, before.power(world, band), after.power(world, band));
    }

    /// Adds everything to the ledger and begins anew.
    void close(Ledger& ledger);

  private:
    static constexpr std::array<Account, 7> accounts = {&Ledger::emitted, &Ledger::absorbed, &Ledger::escaped,
                                                        &Ledger::cut,     &Ledger::roulette, &Ledger::shading,
                                                        &Ledger::capped};
    using Sum = std::conditional_t<std::is_same_v<Real, float>, Quanta, QuantaLanes>;

    Sum& sum(Account account, int world, int band) {
        std::size_t index = 0;
        while (accounts[index] != account) ++index;
        return sums_[index][static_cast<std::size_t>(world)][static_cast<std::size_t>(band)];
    }
    void add(Account account, int world, int band, const MaskOf<Real>& mask, const Real& power) {
        if constexpr (std::is_same_v<Real, float>)
            sum(account, world, band) += mask ? to_quanta(power) : 0;
        else
            sum(account, world, band).add(mask, power);
    }
    void move(Account account, int world, int band, const MaskOf<Real>& mask, const Real& before, const Real& after) {
        if constexpr (std::is_same_v<Real, float>) {
            sum(account, world, band) += mask ? to_quanta(before) - to_quanta(after) : 0;
        } else {
            sum(account, world, band).add(mask, before);
            sum(account, world, band).subtract(mask, after);
        }
    }

    std::array<std::array<std::array<Sum, band_count>, world_count>, accounts.size()> sums_{};
};

template <class Real>
void Books<Real>::close(Ledger& ledger) {
    for (std::size_t account = 0; account < accounts.size(); ++account)
        for (std::size_t world = 0; world < world_count; ++world)
            for (std::size_t band = 0; band < band_count; ++band) {
                Sum& from = sums_[account][world][band];
                if constexpr (std::is_same_v<Real, float>)
                    (ledger.*accounts[account])[world][band] += from;
                else
                    (ledger.*accounts[account])[world][band] += from.total();
                from = {};
            }
}

}  // namespace brewster::transport
