#pragma once
#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "bins/outline.h"

namespace brewster {

/// A published cell: a linear fit per band, and corner values for the lookup.
struct PublishedLeaf {
    Box<2> box;
    const CellGeometry* geometry = nullptr;
    glm::dvec3 density{0};                ///< mean over the surface
    std::array<glm::dvec3, 2> slopes{};   ///< change over half the cell
    glm::dvec3 standard_error{0};         ///< of the mean
    std::array<glm::dvec3, 4> corners{};  ///< (0,0), (1,0), (0,1), (1,1)
    double freedom = 3;  ///< numbers fitted from this cell's photons alone: 3, less where corners are shared
    glm::dvec3 bend{0};  ///< mean square over the surface of what sharing corners changed

    glm::dvec3 linear(const std::array<double, 2>& x) const {
        return density + (x[0] - geometry->mean[0]) * slopes[0] + (x[1] - geometry->mean[1]) * slopes[1];
    }
};

/// Corners from each cell's own fit: steps at every border.
void keep_own_corners(std::span<PublishedLeaf> leaves);

/// Continuous where the light is: cells that meet at a corner and agree there, within seven standard errors of noise or
/// 30 %, in every band share one value; where a corner hangs on the edge of a larger cell that agrees, it lies on that
/// edge. The shared values are the least-squares projection of all linear fits onto such functions, weighted by area,
/// so flux is kept: the integral against every corner's hat function stays. `locate` gives the leaf under fixed-point
/// (u, v).
void join_corners(std::span<PublishedLeaf> leaves,
                  const std::function<std::uint32_t(std::uint32_t u, std::uint32_t v)>& locate);

}  // namespace brewster
