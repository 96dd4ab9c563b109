#pragma once
#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "bins/outline.h"

namespace brewster {

/// A published cell: a linear fit per band, and the same as corner values and a bubble, ready for the lookup.
struct PublishedLeaf {
    Box<2> box;
    const CellGeometry* geometry = nullptr;
    glm::dvec3 density{0};                   ///< mean over the surface
    std::array<glm::dvec3, 2> slopes{};      ///< change over half the cell
    glm::dvec3 standard_error{0};            ///< of the mean
    std::array<glm::dvec3, 4> corners{};     ///< (0,0), (1,0), (0,1), (1,1)
    glm::dvec3 bubble{0};                    ///< added at the middle, zero at the border

    glm::dvec3 linear(const std::array<double, 2>& x) const {
        return density + (x[0] - geometry->mean[0]) * slopes[0] + (x[1] - geometry->mean[1]) * slopes[1];
    }
};

/// Corners from each cell's own fit: steps at every border.
void keep_own_corners(std::span<PublishedLeaf> leaves);

/// Cells that meet at a corner and agree there within three standard errors in every band get one value, the mean
/// weighted by area; where a corner hangs on the edge of a larger cell that agrees, it takes the value of that edge.
/// The bubble then restores each cell's mean. `locate` gives the index of the leaf under fixed-point (u, v).
void share_corners(std::span<PublishedLeaf> leaves,
                   const std::function<std::uint32_t(std::uint32_t u, std::uint32_t v)>& locate);

}  // namespace brewster
