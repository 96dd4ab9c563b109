#include "bins/outline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "shared/bin_layout.h"

namespace brewster {
namespace {

using Point = glm::dvec2;

// A convex polygon: a triangle clipped by four half planes has at most seven corners, cut again at two axes nine.
struct Polygon {
    std::array<Point, 12> corners;
    int count = 0;
    void add(const Point& p) { corners[static_cast<std::size_t>(count++)] = p; }
};

// The part of the polygon with sign * (p[axis] - limit) <= 0.
Polygon clip(const Polygon& polygon, int axis, double limit, double sign) {
    Polygon inside;
    for (int i = 0; i < polygon.count; ++i) {
        const Point& a = polygon.corners[static_cast<std::size_t>(i)];
        const Point& b = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
        if (da <= 0) inside.add(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
            Point crossing = a + (da / (da - db)) * (b - a);
            crossing[axis] = limit;
            inside.add(crossing);
        }
    }
    return inside;
}

Polygon clip(Polygon polygon, Point low, Point high) {
    for (int axis = 0; axis < 2 && polygon.count > 0; ++axis) {
        polygon = clip(polygon, axis, low[axis], -1.0);
        if (polygon.count > 0) polygon = clip(polygon, axis, high[axis], 1.0);
    }
    return polygon;
}

double twice_area(const Point& a, const Point& b, const Point& c) {
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// Six-point rule on a triangle, exact to degree 4 (Dunavant 1985): barycentric (1 - 2 b, b, b) and weight.
constexpr std::array<std::array<double, 2>, 2> dunavant = {
    {{0.44594849091596483, 0.22338158967801144}, {0.09157621350977073, 0.10995174365532187}}};

template <class Integrand>
void integrate(const Polygon& polygon, Integrand&& integrand) {
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const std::array<Point, 3> p = {polygon.corners[0], polygon.corners[static_cast<std::size_t>(i)],
                                        polygon.corners[static_cast<std::size_t>(i + 1)]};
        const double area = 0.5 * twice_area(p[0], p[1], p[2]);
        for (const auto& [b, weight] : dunavant)
            for (std::size_t corner = 0; corner < 3; ++corner)
                integrand((1 - 2 * b) * p[corner] + b * (p[(corner + 1) % 3] + p[(corner + 2) % 3]), area * weight);
    }
}

// Box coordinates: x = -1 at low, 1 at high.
Polygon in_cell(const std::array<Point, 3>& triangle, const Box<2>& box) {
    Polygon polygon;
    for (const Point& corner : triangle) {
        Point p;
        for (int axis = 0; axis < 2; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double low = box.low[a], size = static_cast<double>(box.high[a]) - low;
            p[axis] = 2 * (corner[axis] * BREWSTER_UV_ONE - low) / size - 1;
        }
        polygon.add(p);
    }
    return polygon;
}

CellGeometry full_cell(double area) {
    CellGeometry g;
    g.area = area;
    g.covariance = {1.0 / 3, 0, 1.0 / 3};
    g.xxyy = 1.0 / 9;
    g.full = true;
    return g;
}

// Whether a triangle, in cell coordinates, lies on one side of both axes and inside the cell: nothing to clip.
struct Place {
    bool outside, inside, one_quadrant;
};

Place place_of(const Polygon& triangle) {
    Point low = triangle.corners[0], high = low;
    for (std::size_t i = 1; i < 3; ++i) {
        low = glm::min(low, triangle.corners[i]);
        high = glm::max(high, triangle.corners[i]);
    }
    Place place;
    place.outside = low.x >= 1 || low.y >= 1 || high.x <= -1 || high.y <= -1;
    place.inside = low.x >= -1 && low.y >= -1 && high.x <= 1 && high.y <= 1;
    place.one_quadrant = place.inside && (low.x >= 0 || high.x <= 0) && (low.y >= 0 || high.y <= 0);
    return place;
}

}  // namespace

std::vector<std::uint32_t> triangles_in(const Outline& outline, const Box<2>& box,
                                        std::span<const std::uint32_t> triangles) {
    std::vector<std::uint32_t> inside;
    for (const std::uint32_t index : triangles) {
        const Polygon triangle = in_cell(outline.triangles[index], box);
        const Place place = place_of(triangle);
        if (place.outside) continue;
        if (place.inside || clip(triangle, Point(-1), Point(1)).count >= 3) inside.push_back(index);
    }
    return inside;
}

CellGeometry cell_geometry(const Outline& outline, const Box<2>& box, std::span<const std::uint32_t> triangles) {
    const double box_area = outline.size.x * outline.size.y *
                            (static_cast<double>(box.high[0] - box.low[0]) / BREWSTER_UV_ONE) *
                            (static_cast<double>(box.high[1] - box.low[1]) / BREWSTER_UV_ONE);
    double area = 0;  // in cell coordinates, where the box has 4
    Point first(0), sign(0);
    double xx = 0, xy = 0, yy = 0, xxy = 0, xyy = 0, xxyy = 0, sign_product = 0;
    Point low(1), high(-1);
    for (const std::uint32_t index : triangles) {
        const double stretch = outline.stretch.empty() ? 1.0 : outline.stretch[index];
        const Polygon triangle = in_cell(outline.triangles[index], box);
        const Place place = place_of(triangle);
        if (place.outside) continue;
        const auto add_quadrant = [&](const Polygon& quadrant, double sx, double sy) {
            integrate(quadrant, [&](const Point& p, double projected) {
                const double weight = stretch * projected;
                area += weight;
                first += weight * p;
                xx += weight * p.x * p.x;
                xy += weight * p.x * p.y;
                yy += weight * p.y * p.y;
                sign += weight * Point(sx, sy);
                sign_product += weight * sx * sy;
                xxy += weight * p.x * p.x * p.y;
                xyy += weight * p.x * p.y * p.y;
                xxyy += weight * p.x * p.x * p.y * p.y;
            });
        };
        const Polygon whole = place.inside ? triangle : clip(triangle, Point(-1), Point(1));
        for (int i = 0; i < whole.count; ++i) {
            const Point& p = whole.corners[static_cast<std::size_t>(i)];
            for (int axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
        if (place.one_quadrant) {
            const Point middle = whole.corners[0] + whole.corners[1] + whole.corners[2];
            add_quadrant(whole, middle.x < 0 ? -1 : 1, middle.y < 0 ? -1 : 1);
            continue;
        }
        for (const double sx : {-1.0, 1.0})
            for (const double sy : {-1.0, 1.0})
                add_quadrant(clip(whole, Point(std::min(sx, 0.0), std::min(sy, 0.0)),
                                  Point(std::max(sx, 0.0), std::max(sy, 0.0))),
                             sx, sy);
    }
    if (outline.stretch.empty() && area > 4 * (1 - 1e-9)) return full_cell(box_area);
    CellGeometry g;
    if (area <= 0) return g;
    g.area = box_area * area / 4;
    const Point mean = first / area;
    g.mean = {mean.x, mean.y};
    g.covariance = {xx / area - mean.x * mean.x, xy / area - mean.x * mean.y, yy / area - mean.y * mean.y};
    g.legendre = {1.5 * xx / area - 0.5, 1.5 * yy / area - 0.5};
    g.sign = {sign.x / area, sign.y / area};
    g.sign_product = sign_product / area;
    g.xxy = xxy / area;
    g.xyy = xyy / area;
    g.xxyy = xxyy / area;
    g.middle = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
    return g;
}

}  // namespace brewster
