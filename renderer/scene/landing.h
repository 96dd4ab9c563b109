#pragma once
#include <cstdint>
#include <vector>

#include "base/rows.h"
#include "optics/vector.h"
#include "scene/scene.h"

/// Where rays land, from the triangle they hit and its barycentric coordinates: for one ray or a batch of lanes.
namespace brewster {

/// What a landing needs to know of a triangle, ready to be read as rows of floats.
struct alignas(32) LandingTriangle {
    glm::vec3 corner{0.0f}, edge1{0.0f}, edge2{0.0f};  ///< the first corner, and from it to the others
    glm::vec3 margin{0.0f};                            ///< Triangle::margin
    glm::vec3 normal{0.0f};                            ///< unit, of the front: its plane's, on a patch its facet's
    std::uint32_t padding = 0;
    std::uint32_t front_chart = no_chart, back_chart = no_chart;
    std::uint32_t smooth = 0;   ///< 1: shaded by its corners' normals
    std::uint32_t cut_out = 0;  ///< 1: its material has holes
    std::array<std::uint32_t, 4> more_padding{};

    std::uint32_t chart(bool from_front) const { return from_front ? front_chart : back_chart; }
};
static_assert(sizeof(LandingTriangle) == 3 * sizeof(Row));

/// The same of a chart.
struct alignas(32) LandingChart {
    glm::vec3 origin{0.0f}, axis_u{1, 0, 0}, axis_v{0, 1, 0};
    float size_u = 1, size_v = 1;
    glm::vec3 normal{0, 0, 1};
    std::array<std::uint32_t, 2> padding{};
};
static_assert(sizeof(LandingChart) == 2 * sizeof(Row));

/// Normals of a triangle's corners; zero where it is flat.
struct alignas(32) LandingNormals {
    std::array<glm::vec3, 3> at{};
    std::array<float, 7> padding{};
};
static_assert(sizeof(LandingNormals) == 2 * sizeof(Row));

struct LandingTable {
    explicit LandingTable(const Scene& scene);

    std::vector<LandingTriangle> triangles;
    std::vector<LandingChart> charts;
    std::vector<LandingNormals> normals;  ///< per triangle; none where all is flat
};

template <class Real>
struct Barycentric {
    Real b1, b2;
};

template <class Real>
struct TriangleShape {
    Vector<Real> corner, edge1, edge2, margin;
};

/// Scene::point_inside.
template <class Real>
Vector<Real> point_inside(const TriangleShape<Real>& triangle, const Barycentric<Real>& at) {
    const Real b0 = 1 - at.b1 - at.b2;
    const auto inside = [](const Real& b, const Real& margin) { return select(b < margin, margin, b); };
    const Real i0 = inside(b0, triangle.margin.x), i1 = inside(at.b1, triangle.margin.y),
               i2 = inside(at.b2, triangle.margin.z);
    const Real excess = i0 + i1 + i2 - 1;
    const auto first_below = i1 > i0;
    const auto third = i2 > select(first_below, i1, i0);
    const Real b1 = select(first_below && !third, i1 - excess, i1), b2 = select(third, i2 - excess, i2);
    return triangle.corner + b1 * triangle.edge1 + b2 * triangle.edge2;
}

/// Scene::shading_normal.
template <class Real>
Vector<Real> interpolated_normal(const std::array<Vector<Real>, 3>& corners, const Vector<Real>& facet,
                                 const Barycentric<Real>& at) {
    const Vector<Real> sum = (1 - at.b1 - at.b2) * corners[0] + at.b1 * corners[1] + at.b2 * corners[2];
    const auto dot_of = [](const Vector<Real>& a, const Vector<Real>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const Real length = sqrt(dot_of(sum, sum));
    constexpr double shortest = 1e-3, least_cosine = 1e-3;
    const auto poor = length < constant<Real>(shortest) || dot_of(sum, facet) < constant<Real>(least_cosine) * length;
    const Real inverse = 1 / select(poor, Real(1), length);
    return select(poor, facet, inverse * sum);
}

/// Whether a ray meets the side that a normal points to.
template <class Real>
auto is_met_in_front(const Vector<Real>& normal, const Vector<Real>& direction) {
    return dot(normal, direction) < 0;
}

/// A place on a chart's rectangle, [0, 1]; outside beyond it.
template <class Real>
struct UnitCoordinates {
    Real u, v;
};

/// A chart's rectangle.
template <class Real>
struct ChartShape {
    Vector<Real> origin, axis_u, axis_v;
    Real size_u, size_v;
};

/// Chart::unit_coordinates.
template <class Real>
UnitCoordinates<Real> unit_coordinates(const ChartShape<Real>& chart, const Vector<Real>& position) {
    const Vector<Real> d = position - chart.origin;
    return {(d.x * chart.axis_u.x + d.y * chart.axis_u.y + d.z * chart.axis_u.z) / chart.size_u,
            (d.x * chart.axis_v.x + d.y * chart.axis_v.y + d.z * chart.axis_v.z) / chart.size_v};
}

/// chart_fixed_point.
template <class Real>
Word<Real> fixed_coordinate(const Real& unit) {
    const Real bounded = select(unit < 0, Real(0), select(unit > 1, Real(1), unit));
    const Real scaled = bounded * constant<Real>(16777216.0), most = constant<Real>(16777215.0);
    return truncated(select(scaled < most, scaled, most));
}

}  // namespace brewster
