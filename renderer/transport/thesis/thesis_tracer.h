#pragma once
#include <memory>

#include "transport/kernel.h"

namespace brewster {

/// Habits of the 1997 method that concern photons, one by one, so that each can be compared with what replaced it. Those
/// of its bins are in BinSettings.
struct ThesisRules {
    /// Gloss of Beckmann slopes goes where the thesis's sampler says (optics/thesis_sampler.h), which is biased. Kirchhoff
    /// surfaces keep their own.
    bool sampler = false;
    /// A photon lives or dies at each surface with what is left of its weight, and is counted only where it lives: as
    /// light that leaves in one direction, never as an expected value.
    bool analog = false;

    bool any() const { return sampler || analog; }
};

/// Moves photons one by one, by the scalar engine's loop, with these rules. Of kernels with three bands, and one or four
/// Stokes components.
std::unique_ptr<PhotonTracer> make_thesis_tracer(const KernelChoice& choice, const ThesisRules& rules);

}  // namespace brewster
