#pragma once
#include <optional>

#include "reference/path_class.h"
#include "reference/path_random.h"
#include "reference/surroundings.h"
#include "scene/emission.h"

namespace brewster {

/// A photon between two surfaces: Stokes vectors of all bands in the frame of `axis`, lumen.
template <int components>
struct Photon {
    Vector<double> position{}, direction{}, axis{};
    std::uint32_t leaving = no_triangle;
    std::array<Stokes<double, components>, band_count> light{};
    std::uint32_t lamp = 0;
    double reference = 0;  ///< largest band at emission, for the roulette

    double largest() const { return std::max(light[0].s0(), std::max(light[1].s0(), light[2].s0())); }
};

/// Photons of a scene's lamps, one path at a time; nothing is kept about them. Constant.
class PhotonSource {
  public:
    explicit PhotonSource(const Surroundings& surroundings);  ///< keeps a reference

    bool any() const { return !cumulative_.empty(); }

    /// A photon of one lamp, drawn by power: the mean over photons of what they carry is the lamps' whole power.
    template <int components>
    Photon<components> emit(const PathRandom& random) const;

  private:
    Emission start_of_sun(const Lamp& lamp, const std::array<double, 4>& numbers, glm::dvec3& power) const;

    const Surroundings& surroundings_;
    const LampSampler sampler_;
    std::vector<double> cumulative_, choice_;
};

/// Takes a photon on from a surface; the event, or none where it ends.
template <int components>
std::optional<Event> scatter(Photon<components>& photon, const Vertex& vertex, const BounceNumbers& numbers);

/// Plays for photons whose weight has fallen below a quarter of that at emission: false for the losers, while survivors
/// are raised to it.
template <int components>
bool survives_roulette(Photon<components>& photon, const BounceNumbers& numbers);

}  // namespace brewster
