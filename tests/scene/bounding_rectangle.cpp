#include "scene/bounding_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brewster {
namespace {

glm::dvec2 turned(glm::dvec2 p, double angle) {
    return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

double area(const BoundingRectangle& r) {
    return r.length * r.width;
}

void expect_inside(const BoundingRectangle& r, const std::vector<glm::dvec2>& points) {
    for (const glm::dvec2 p : points) {
        const glm::dvec2 d = p - r.corner;
        const double s = d.x * r.axis.x + d.y * r.axis.y, t = d.y * r.axis.x - d.x * r.axis.y;
        EXPECT_GT(s, -1e-12);
        EXPECT_LT(s, r.length + 1e-12);
        EXPECT_GT(t, -1e-12);
        EXPECT_LT(t, r.width + 1e-12);
    }
}

TEST(BoundingRectangle, OfATurnedRectangleIsItself) {
    for (double angle = 0; angle < 6.3; angle += 0.1) {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec2 p : {glm::dvec2{0, 0}, {3, 0}, {3, 2}, {0, 2}, {1.5, 0}, {1, 1}})
            corners.push_back(turned(p, angle) + glm::dvec2(7, -4));
        const BoundingRectangle r = smallest_rectangle(corners);
        EXPECT_NEAR(r.length, 3, 1e-9);  // along the longest edge
        EXPECT_NEAR(r.width, 2, 1e-9);
        expect_inside(r, corners);
    }
}

TEST(BoundingRectangle, OfATriangleStandsOnItsLongestSide) {
    const std::vector<glm::dvec2> corners = {{0, 0}, {4, 0}, {0, 3}};
    const BoundingRectangle r = smallest_rectangle(corners);
    EXPECT_NEAR(area(r), 12, 1e-12);  // twice the triangle, on any side
    EXPECT_NEAR(r.length, 5, 1e-12);
    expect_inside(r, corners);
}

// No direction of 10000 gives a smaller rectangle, for random clouds; along hull edges alone the minimum is reached.
TEST(BoundingRectangle, IsTheSmallest) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int cloud = 0; cloud < 50; ++cloud) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i < 3 + cloud; ++i) points.push_back({unit(engine), 0.3 * unit(engine) * (1 + cloud % 3)});
        const BoundingRectangle r = smallest_rectangle(points);
        expect_inside(r, points);
        for (int k = 0; k < 10000; ++k) {
            double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
            for (const glm::dvec2 p : points) {
                const glm::dvec2 q = turned(p, k * 1.5707963267948966 / 10000);
                low_x = std::min(low_x, q.x), high_x = std::max(high_x, q.x);
                low_y = std::min(low_y, q.y), high_y = std::max(high_y, q.y);
            }
            ASSERT_LE(area(r), (high_x - low_x) * (high_y - low_y) * (1 + 1e-6));
        }
    }
}

TEST(BoundingRectangle, OfALineHasNoWidth) {
    const BoundingRectangle r = smallest_rectangle({{0, 0}, {1, 1}, {3, 3}, {2, 2}});
    EXPECT_NEAR(r.length, std::sqrt(18.0), 1e-12);
    EXPECT_NEAR(r.width, 0, 1e-12);
}

}  // namespace
}  // namespace brewster
