#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/rows.h"
#include "base/sobol.h"
#include "base/units.h"
#include "bins/record.h"
#include "scene/emission.h"
#include "scene/scene.h"
#include "transport/guided_emission.h"

namespace brewster {

/// A photon on its way, or a batch of them. Its weight has a band mean of `scale` at emission: mean_power() / photons
/// lumen a unit.
template <class Real>
struct EmittedPhoton {
    PhotonStart<Real> start;
    std::array<Real, band_count> weight;
    Real scale{1};            ///< of the weight, where starts are guided
    Word<Real> lamp{};        ///< in Scene::lamps
    Word<Real> guide_cell{};  ///< where the start counts in the guide
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

    EmittedPhoton<float> sample(std::uint64_t photon) const;
    EmittedPhoton<FloatLanes> sample_lanes(std::uint64_t first) const;  ///< the same of photons in a row

    bool polarized() const { return polarized_; }  ///< whether some lamp's light is

    const EmissionGuide& guide() const { return guide_; }
    EmissionGuide& guide() { return guide_; }  ///< between batches

    /// This photon's number in one dimension of its sequence, below sobol_dimensions; in [0, 1).
    float sobol(std::uint64_t photon, unsigned dimension) const;
    FloatLanes sobol(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const;  ///< in lanes

  private:
    std::uint32_t sobol_word(std::uint64_t photon, unsigned dimension) const;
    WordLanes sobol_words(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const;
    template <class Real>
    EmittedPhoton<Real> sample_by(const Word<Real>& lamp, const std::array<Word<Real>, 4>& words) const;
    std::uint32_t lamp_of(std::uint32_t word) const;

    const LampSampler sampler_;
    EmissionGuide guide_;
    std::uint64_t seed_;
    double mean_power_ = 0;
    std::vector<std::uint64_t> cumulative_;  // in 2^-32: the share of the lamps up to and including each; ends in 2^32
    std::vector<Row> weights_;               // per lamp: by its colour, then whether it is a sun
    bool polarized_ = false;
    std::array<std::array<std::uint32_t, sobol_dimensions>, replica_count> scrambles_{};
};

}  // namespace brewster
