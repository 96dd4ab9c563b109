#include "scene/bounding_rectangle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"

namespace brewster {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Andrew's monotone chain, counter-clockwise, without repeated or collinear points.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
    std::sort(points.begin(), points.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<glm::dvec2> hull;
    const auto add = [&hull](glm::dvec2 p, std::size_t fixed) {
        while (hull.size() >= fixed + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const glm::dvec2 p : points) add(p, 0);
    hull.pop_back();
    const std::size_t lower = hull.size();
    for (auto p = points.rbegin(); p != points.rend(); ++p) add(*p, lower);
    hull.pop_back();
    return hull;
}

}  // namespace

BoundingRectangle smallest_rectangle(std::vector<glm::dvec2> points) {
    BREWSTER_CHECK(!points.empty(), "no points");
    const std::vector<glm::dvec2> hull = convex_hull(std::move(points));
    const std::size_t n = hull.size();
    BoundingRectangle best{hull[0], {1, 0}, 0, 0};
    double best_area = INFINITY, best_edge = 0;
    // Rotating calipers: as the edge turns, the furthest points along it, away from it and against it only advance.
    std::size_t ahead = 1, above = 1, behind = 1;
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const glm::dvec2 edge = hull[(i + 1) % n] - hull[i];
        const double edge_length = glm::length(edge);
        const glm::dvec2 u = edge / edge_length, v{-u.y, u.x};
        const auto advance = [&](std::size_t& k, glm::dvec2 direction) {
            while (glm::dot(hull[(k + 1) % n] - hull[k % n], direction) > 0) ++k;
        };
        ahead = std::max(ahead, i + 1);
        advance(ahead, u);
        above = std::max(above, ahead);
        advance(above, v);
        behind = std::max(behind, above);
        advance(behind, -u);
        const double low = glm::dot(hull[behind % n] - hull[i], u), high = glm::dot(hull[ahead % n] - hull[i], u);
        const double width = glm::dot(hull[above % n] - hull[i], v);
        const double area = (high - low) * width;
        if (area < best_area * (1 - 1e-6) || (area < best_area * (1 + 1e-6) && edge_length > best_edge)) {
            best = {hull[i] + low * u, u, high - low, width};
            best_area = std::min(area, best_area);
            best_edge = edge_length;
        }
    }
    return best;
}

}  // namespace brewster
