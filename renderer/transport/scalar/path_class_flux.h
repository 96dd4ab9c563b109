#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "transport/context.h"

namespace brewster {

/// Flux that photons bring along one class of paths, in both worlds, in units of photon weight over the photons emitted.
struct PathClassFlux {
    std::array<double, band_count> polarized{}, unpolarized{};
    double ratio = 0, ratio_standard_error = 0;  ///< polarized over unpolarized, sums of the bands
};

/// Follows photons [0, count) with the engine's own emission and events, one at a time, and adds up what arrives at the
/// last of these meshes by way of all others in this order, with nothing between: sun -> floor -> side -> back wall of the
/// thesis's figure 8.1. For tests; files nothing. An unknown mesh is an Error.
PathClassFlux path_class_flux(const TransportContext& context, const std::vector<std::string>& meshes,
                              std::uint64_t count);

}  // namespace brewster
