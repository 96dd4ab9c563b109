#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/units.h"
#include "reference/surroundings.h"

namespace brewster {

/// Flux that arrives at a surface along one class of paths, lumen per band, in both worlds at once: the same paths
/// carry both, so that their ratio is known far better than either.
struct PathFlux {
    struct World {
        std::array<double, band_count> mean{}, standard_error{};
    };
    World polarized, unpolarized;
    double ratio = 0, ratio_standard_error = 0;  ///< polarized over unpolarized, sums of the bands
};

/// Photons that meet exactly these meshes in this order after their lamp (the last receives; nothing else lies
/// between), without roulette: the flux of a class such as sun -> floor -> side -> back wall (thesis, figure 8.1).
/// An unknown mesh is an Error. A function of seed and number of photons alone.
PathFlux path_flux(const Surroundings& surroundings, const std::vector<std::string>& meshes, std::uint64_t photons,
                   std::uint64_t seed, unsigned threads);

}  // namespace brewster
