#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "bins/record.h"
#include "scene/lamp.h"
#include "scene/rays.h"
#include "scene/scene.h"

namespace brewster {

/// A photon as it leaves a lamp. Its weight has a band mean of 1: mean_power() / photons lumen a unit.
struct EmittedPhoton {
    Ray ray;
    glm::vec3 weight{0.0f};
};

/// Chooses lamps by their power and points and directions on them, by an Owen-scrambled Sobol sequence a replica
/// (photon index mod 8): every prefix of the photons covers all lamps evenly.
class Emission {
  public:
    /// Dimensions of the sequence that emission uses; the next two are left for the first bounce.
    static constexpr unsigned dimensions = 5;

    Emission(const Scene& scene, std::uint64_t seed);

    /// False if no lamp of the scene has power.
    bool any() const { return mean_power_ > 0; }
    double mean_power() const { return mean_power_; }  ///< lumen, all lamps, mean of the bands

    EmittedPhoton sample(std::uint64_t photon) const;

    /// Uniform in [0, 1): the Sobol number of this photon in one of its dimensions.
    float sobol(std::uint64_t photon, unsigned dimension) const;

  private:
    const Scene& scene_;
    std::uint64_t seed_;
    double mean_power_ = 0;
    std::vector<float> cumulative_;  // share of the lamps up to and including each
    std::array<std::array<std::uint32_t, 8>, replica_count> scrambles_{};
};

}  // namespace brewster
