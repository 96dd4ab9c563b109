#pragma once
#include <cstdint>
#include <memory>

#include "scene/needs.h"
#include "transport/context.h"

namespace brewster {

/// What a photon must carry. The smallest that is exact for a scene is found by scene/needs.
struct KernelChoice {
    int stokes = 1;  ///< components: 1, 3 or 4
    int bands = 3;   ///< 1 or 3
    bool gloss = false;
    bool operator==(const KernelChoice&) const = default;
};

/// What a kernel files for the bins of entered light.
EntryFields entry_fields_of(const KernelChoice& choice, const Needs& needs);

/// Follows photons from their lamps until they are absorbed, escape or lose the roulette. What a photon tallies depends
/// on the seed and its index alone. A tracer belongs to one thread: it may keep memory from call to call, but nothing
/// that a result could depend on.
class PhotonTracer {
  public:
    virtual ~PhotonTracer() = default;

    /// The photons of [begin, end).
    virtual void trace(const TransportContext& context, std::uint64_t begin, std::uint64_t end, WorkerSums& sums) = 0;
};

inline constexpr std::size_t default_window = 2048;  ///< photons on their way at once; flat from 1024 up

/// 16 where the program and the processor have AVX-512, else 8.
int widest_lanes();

/// `window`: how many photons are on their way at once, `lanes` at a time; 0: one after the other, by the scalar engine
/// that is the oracle of the others. The same tallies for all.
std::unique_ptr<PhotonTracer> make_tracer(const KernelChoice& choice, std::size_t window = default_window,
                                          int lanes = widest_lanes());

}  // namespace brewster
