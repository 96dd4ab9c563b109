#pragma once
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "base/units.h"
#include "scene/surfaces.h"

namespace brewster {

/// A mesh over the square [0, 1]^2 in columns x rows quads of two triangles, with the front where du x dv points.
/// `point(s, t)` gives the vertices; `normal(s, t)`, unit, their normals. Quads of a sphere's poles lose one triangle.
template <class PointOf, class NormalOf>
Part curved_part(std::uint32_t columns, std::uint32_t rows, const PointOf& point, const NormalOf& normal) {
    Part part{"curved", "curved", 0, {}, {}, {}};
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i) {
            const double s = static_cast<double>(i) / columns, t = static_cast<double>(j) / rows;
            part.vertices.emplace_back(point(s, t));
            part.normals.emplace_back(normal(s, t));
        }
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = a + columns + 1;
            part.triangles.push_back({a, b, c});
            part.triangles.push_back({a, c, d});
        }
    return part;
}

/// A sphere around the origin by longitude and latitude, or its part below `highest` (radians from the south pole);
/// sign 1 faces outwards, -1 inwards. The seam's vertices are equal numbers.
inline Part sphere_part(std::uint32_t rows, double radius, double sign, double highest = pi) {
    const std::uint32_t columns = 2 * rows;
    const auto direction = [=](double s, double t) {
        const double around = sign > 0 ? s : 1 - s;
        const double turn = 2 * pi * (around == 1 ? 0 : around), polar = highest * t;
        const double sine = t == 0 || (t == 1 && highest == pi) ? 0 : std::sin(polar);
        return glm::dvec3(sine * std::cos(turn), sine * std::sin(turn), -std::cos(polar));
    };
    return curved_part(
        columns, rows, [=](double s, double t) { return radius * direction(s, t); },
        [=](double s, double t) { return sign * direction(s, t); });
}

inline Part torus_part(std::uint32_t rows, double large, double small) {
    const auto turned = [](double s) { return 2 * pi * (s == 1 ? 0 : s); };
    const auto normal = [=](double s, double t) {
        const double a = turned(s), b = turned(t);
        return glm::dvec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
    };
    return curved_part(
        2 * rows, rows,
        [=](double s, double t) {
            const double a = turned(s);
            return large * glm::dvec3(std::cos(a), std::sin(a), 0) + small * normal(s, t);
        },
        normal);
}

inline Part saddle_part(std::uint32_t rows) {
    return curved_part(
        rows, rows,
        [](double s, double t) {
            const double x = s - 0.5, y = t - 0.5;
            return glm::dvec3(x, y, x * x - y * y);
        },
        [](double s, double t) { return glm::normalize(glm::dvec3(1 - 2 * s, 2 * t - 1, 1)); });
}

}  // namespace brewster
