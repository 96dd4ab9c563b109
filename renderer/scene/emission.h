#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "base/word_lanes.h"
#include "optics/vector.h"
#include "scene/scene.h"

namespace brewster {

/// A photon as it leaves its lamp: it carries the lamp's power over the number of photons, whatever the numbers were.
struct Emission {
    glm::vec3 position{0.0f}, direction{0.0f};
    std::uint32_t leaving = no_triangle;  ///< the triangle of an area lamp
};

/// The same in the numbers of optics: of one photon, or of a batch of lanes.
template <class Real>
struct PhotonStart {
    Vector<Real> position, direction;
    Word<Real> leaving{};
};

/// Where photons start, of a triangle of an area lamp or of another lamp, ready to be read as rows of floats: a
/// parallelogram of places (of triangles one half) and a frame of directions.
struct alignas(32) StartRow {
    glm::vec3 corner{0.0f}, edge1{0.0f}, edge2{0.0f};
    glm::vec3 shape{0.0f};  ///< area: Triangle::margin; sun: sine of the disc's radius; spot: cosines, inner and outer
    glm::vec3 axis_u{1, 0, 0}, axis_v{0, 1, 0}, middle{0, 0, 1};
    float before = 0, scale = 1;          ///< of the first number: where the triangle's share begins, one over it
    std::uint32_t leaving = no_triangle;  ///< the triangle
};

/// Photon starts of the lamps of a scene, which it refers to. Constant, so any number of threads may ask.
class LampSampler {
  public:
    explicit LampSampler(const Scene& scene);

    /// The start for four numbers in [0, 1): the first two place it, the last two turn it; a stratified set of numbers
    /// gives a stratified set of starts. The first also picks the triangle, so of its 24 bits log2(triangles) are
    /// spent.
    Emission emit(std::uint32_t lamp, const std::array<float, 4>& x) const;
    template <class Real>
    PhotonStart<Real> start(const Word<Real>& lamp, const std::array<Real, 4>& x) const;

    /// Of photon starts per m2 of lamp or beam and per steradian (area, suns with a disc), per m2 (other suns), per
    /// steradian (point, spot).
    /// An area lamp on a curved patch has no one density: there it is pdf_cosine about the facet over the chart's area.
    float pdf(std::uint32_t lamp, glm::vec3 direction) const;

  private:
    std::uint32_t row_of(std::uint32_t lamp, float x) const;

    const Scene& scene_;
    std::vector<SunRectangle> suns_;         // per lamp
    std::vector<std::uint32_t> first_rows_;  // per lamp, and where the last one's end
    std::vector<StartRow> rows_;
};

}  // namespace brewster
