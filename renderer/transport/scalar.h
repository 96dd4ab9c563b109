#pragma once
#include <cstdint>

#include "bins/tree.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "transport/emission.h"
#include "transport/ledger.h"

namespace brewster {

/// What photons did, added up over a thread's share.
struct TransportCounts {
    std::uint64_t photons = 0;
    std::uint64_t useful = 0;   ///< photons that deposited at least once
    std::uint64_t bounces = 0;  ///< surfaces hit
    std::uint64_t rays = 0;
    std::uint64_t trouble = 0;  ///< photons given up: a number was not finite

    void add(const TransportCounts& other);
};

/// Everything one worker tallies.
struct WorkerSums {
    explicit WorkerSums(const EntryFields& fields = {}) : bins(fields.layout()) {}

    Tally<2> bins;
    Ledger ledger;
    TransportCounts counts;
};

/// Transport of one photon at a time, written to be read. Const: any number of threads may trace.
class ScalarTransport {
  public:
    /// Keeps references to all of them.
    ScalarTransport(const Scene& scene, const Rays& rays, const PhotonEmission& emission, const BinTree<2>& tree,
                    std::uint64_t seed)
        : scene_(scene), rays_(rays), emission_(emission), tree_(tree), seed_(seed) {}

    /// Follows one photon from its lamp until it is absorbed, escapes or loses the roulette. The result depends on the
    /// seed and the photon's index alone.
    void trace(std::uint64_t photon, WorkerSums& sums) const;

  private:
    const Scene& scene_;
    const Rays& rays_;
    const PhotonEmission& emission_;
    const BinTree<2>& tree_;
    std::uint64_t seed_;
};

}  // namespace brewster
