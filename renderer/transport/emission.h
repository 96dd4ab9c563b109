#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/sobol.h"
#include "bins/record.h"
#include "scene/emission.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "transport/guided_emission.h"

namespace brewster {

/// A photon on its way. Its weight has a band mean of `scale` at emission: mean_power() / photons lumen a unit.
struct EmittedPhoton {
    Ray ray;
    glm::vec3 weight{0.0f};
    float scale = 1;               ///< of the weight, where starts are guided
    std::uint32_t lamp = 0;        ///< in Scene::lamps
    std::uint32_t guide_cell = 0;  ///< where the start counts in the guide
};

/// Chooses lamps by their power and starts on them, by an Owen-scrambled Sobol sequence a replica (photon index mod 8):
/// every prefix of the photons covers all lamps evenly. A guide warps where on a sun's beam, or in which direction from
/// a point, photons start.
class PhotonEmission {
  public:
    /// Dimensions of the sequence that emission uses: the lamp, and four for the start. Those behind are free.
    static constexpr unsigned dimensions = 5;

    PhotonEmission(const Scene& scene, std::uint64_t seed);  ///< keeps a reference to the scene

    bool any() const { return mean_power_ > 0; }       ///< false if no lamp has power
    double mean_power() const { return mean_power_; }  ///< lumen, all lamps, mean of the bands

    EmittedPhoton sample(std::uint64_t photon) const;

    /// The same of up to eight photons in a row.
    void sample(std::uint64_t first, std::span<EmittedPhoton> photons) const;

    const EmissionGuide& guide() const { return guide_; }
    EmissionGuide& guide() { return guide_; }  ///< between batches

    /// This photon's number in one dimension of its sequence, below sobol_dimensions; in [0, 1).
    float sobol(std::uint64_t photon, unsigned dimension) const;
    FloatLanes sobol(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const;  ///< of eight photons

  private:
    using Words = std::array<std::uint32_t, dimensions>;

    std::uint32_t sobol_word(std::uint64_t photon, unsigned dimension) const;
    WordLanes sobol_words(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const;
    EmittedPhoton sample_by(const Words& words) const;

    const Scene& scene_;
    const LampSampler sampler_;
    EmissionGuide guide_;
    std::uint64_t seed_;
    double mean_power_ = 0;
    std::vector<std::uint64_t> cumulative_;  // in 2^-32: the share of the lamps up to and including each; ends in 2^32
    std::vector<glm::vec3> weights_;         // per lamp
    std::array<std::array<std::uint32_t, sobol_dimensions>, replica_count> scrambles_{};
};

}  // namespace brewster
