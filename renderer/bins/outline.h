#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "shared/bin_layout.h"

namespace brewster {

/// The part of a chart's bounding rectangle that is surface: triangles in (u, v) of [0, 1]^2, in any order and winding.
/// On a curved chart they are projections of the surface.
struct Outline {
    std::vector<std::array<glm::dvec2, 3>> triangles;
    std::vector<double> stretch;  ///< curved charts: area of surface over projected area, of each triangle; flat: none
    glm::dvec2 size{1, 1};        ///< metres along u and v
    std::vector<std::pair<glm::dvec2, glm::dvec2>> contacts;  ///< lines where other surfaces touch or cross this one
    std::uint32_t least_cell = BREWSTER_UV_ONE >> 12;         ///< fixed-point: no cell is made smaller along any axis
};

/// An axis-parallel box of fixed-point coordinates, [low, high): position u, v, then direction where there is one.
template <int D>
struct Box {
    std::array<std::uint32_t, D> low{}, high{};
};

/// Moments of area of the surface inside a cell, about cell coordinates (x, y) of [-1, 1]^2.
struct CellGeometry {
    double area = 0;                     ///< m2 of surface inside the cell
    std::array<double, 2> mean{};        ///< of x, y
    std::array<double, 3> covariance{};  ///< of (x, x), (x, y), (y, y)
    std::array<double, 2> legendre{};    ///< mean of (3 x^2 - 1) / 2 and of the same in y
    std::array<double, 2> sign{};        ///< mean of the sign of x, of y
    double sign_product = 0;             ///< mean of sign x sign y
    double xxy = 0, xyy = 0, xxyy = 0;   ///< means of x^2 y, x y^2, x^2 y^2
    std::array<double, 2> middle{};      ///< middle of what is occupied along x, y
    bool full = false;                   ///< all of the cell is surface, and flat
};

/// Clips the listed triangles of the outline to the box and integrates. Exact up to rounding: every integrand is a
/// polynomial of degree <= 4 on pieces cut at x = 0 and y = 0.
CellGeometry cell_geometry(const Outline& outline, const Box<2>& box, std::span<const std::uint32_t> triangles);

/// Those of the listed triangles that share area with the box.
std::vector<std::uint32_t> triangles_in(const Outline& outline, const Box<2>& box,
                                        std::span<const std::uint32_t> triangles);

}  // namespace brewster
