#include "bins/direction_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "statistics/chi_square.h"

namespace brewster {
namespace {

TEST(DirectionMap, CentreRimAndAxes) {
    const auto at = [](float x, float y) { return direction_map::direction_square({x, y}); };
    EXPECT_EQ(at(0, 0), glm::vec2(0.5f, 0.5f));
    EXPECT_NEAR(at(1, 0).x, 1.0f, 1e-6f);
    EXPECT_NEAR(at(1, 0).y, 0.5f, 1e-6f);
    EXPECT_NEAR(at(0, -1).y, 0.0f, 1e-6f);
    const float diagonal = std::sqrt(0.5f);
    EXPECT_NEAR(at(diagonal, diagonal).x, 1.0f, 1e-6f);
    EXPECT_NEAR(at(diagonal, diagonal).y, 1.0f, 1e-6f);
    EXPECT_NEAR(at(-diagonal, diagonal).x, 0.0f, 1e-6f);
}

// No step anywhere: points of the disk that are close stay close, across the diagonals and the axes.
TEST(DirectionMap, NeighboursStayNeighbours) {
    for (int i = 0; i < 4000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 4000, next = 2 * std::numbers::pi * (i + 1) / 4000;
        for (const double radius : {0.01, 0.5, 0.999}) {
            const auto point = [&](double a) {
                return direction_map::direction_square(
                    {static_cast<float>(radius * std::cos(a)), static_cast<float>(radius * std::sin(a))});
            };
            const glm::vec2 a = point(angle), b = point(next);
            EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 0.0012 * radius + 1e-6) << angle;
        }
    }
}

// Points that fill the disk evenly fill the square evenly. Negative control: (radius, azimuth) does not.
TEST(DirectionMap, EqualAreasStayEqual) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> counts(256), polar(256);
    constexpr int points = 200000;
    const auto count = [](std::vector<double>& cells, double x, double y) {
        const auto cell = [](double c) { return static_cast<std::size_t>(std::min(15.0, 16 * c)); };
        ++cells[cell(y) * 16 + cell(x)];
    };
    for (int i = 0; i < points; ++i) {
        const double radius = std::sqrt(uniform(random)), turn = uniform(random);
        const double angle = 2 * std::numbers::pi * turn;
        const glm::vec2 square = direction_map::direction_square(
            {static_cast<float>(radius * std::cos(angle)), static_cast<float>(radius * std::sin(angle))});
        count(counts, static_cast<double>(square.x), static_cast<double>(square.y));
        count(polar, radius, turn);
    }
    const std::vector<double> expected(256, points / 256.0);
    EXPECT_GT(chi_square_test(counts, expected).p_value, 1e-4);
    EXPECT_LT(chi_square_test(polar, expected).p_value, 1e-12);
}

}  // namespace
}  // namespace brewster
