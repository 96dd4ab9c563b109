#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// A photon as it leaves its lamp: it carries the lamp's power over the number of photons, whatever the numbers were.
struct Emission {
    glm::vec3 position{0.0f}, direction{0.0f};
    std::uint32_t leaving = no_triangle;  ///< the triangle of an area lamp
};

/// Photon starts of the lamps of a scene, which it refers to. Constant, so any number of threads may ask.
class LampSampler {
  public:
    explicit LampSampler(const Scene& scene);

    /// The start for four numbers in [0, 1): the first two place it, the last two turn it; a stratified set of numbers
    /// gives a stratified set of starts. The first also picks the triangle, so of its 24 bits log2(triangles) are
    /// spent.
    Emission emit(std::uint32_t lamp, const std::array<float, 4>& x) const;

    /// Of photon starts per m2 of lamp or beam and per steradian (area, suns with a disc), per m2 (other suns), per
    /// steradian (point, spot).
    /// An area lamp on a curved patch has no one density: there it is pdf_cosine about the facet over the chart's area.
    float pdf(std::uint32_t lamp, glm::vec3 direction) const;

  private:
    const Scene& scene_;
    std::vector<std::vector<double>> cumulative_;  // per lamp: area share up to and with each triangle, ends in 1
    std::vector<SunRectangle> suns_;               // per lamp
};

}  // namespace brewster
