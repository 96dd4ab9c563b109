#pragma once
#include <cstdint>

#include "transport/context.h"

namespace brewster {

/// What a photon must carry. The smallest that is exact for a scene is found by scene/needs.
struct KernelChoice {
    int stokes = 1;  ///< components: 1, 3 or 4
    int bands = 3;   ///< 1 or 3
    bool gloss = false;
    bool operator==(const KernelChoice&) const = default;
};

/// Follows one photon from its lamp until it is absorbed, escapes or loses the roulette. The result depends on the seed
/// and the photon's index alone.
using TracePhoton = void (*)(const TransportContext& context, std::uint64_t photon, WorkerSums& sums);

TracePhoton kernel_for(const KernelChoice& choice);

}  // namespace brewster
