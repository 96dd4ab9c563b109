#include "bins/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "shapes.h"
#include "shared/bin_layout.h"

namespace brewster {
namespace {

CellGeometry whole(const Outline& outline) {
    std::vector<std::uint32_t> all(outline.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return cell_geometry(outline, {{0, 0}, {BREWSTER_UV_ONE, BREWSTER_UV_ONE}}, all);
}

TEST(CellGeometry, FullRectangle) {
    const CellGeometry g = whole(shapes::rectangle(2, 3));
    EXPECT_TRUE(g.full);
    EXPECT_NEAR(g.area, 6, 1e-12);
    EXPECT_NEAR(g.covariance[0], 1.0 / 3, 1e-12);
    EXPECT_NEAR(g.xxyy, 1.0 / 9, 1e-12);
}

// Right triangle with corners (-1,-1), (1,-1), (-1,1) in cell coordinates: moments by hand.
TEST(CellGeometry, RightTriangle) {
    const CellGeometry g = whole(shapes::right_triangle());
    EXPECT_FALSE(g.full);
    EXPECT_NEAR(g.area, 0.5, 1e-14);
    EXPECT_NEAR(g.mean[0], -1.0 / 3, 1e-14);
    EXPECT_NEAR(g.mean[1], -1.0 / 3, 1e-14);
    EXPECT_NEAR(g.covariance[0], 2.0 / 9, 1e-14);
    EXPECT_NEAR(g.covariance[1], -1.0 / 9, 1e-14);
    // x < 0 holds 3/4 of the area, so does y < 0; x < 0 and y < 0 half of it.
    EXPECT_NEAR(g.sign[0], -0.5, 1e-14);
    EXPECT_NEAR(g.sign_product, 0.0, 1e-14);
    EXPECT_NEAR(g.legendre[0], 1.5 * (2.0 / 9 + 1.0 / 9) - 0.5, 1e-14);
    // y runs from -1 to -x: int y dy = (x^2 - 1) / 2, int y^2 dy = (1 - x^3) / 3.
    double xxy = 0, xxyy = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double x = -1 + (i + 0.5) * 2 / n;
        xxy += x * x * (x * x - 1) / 2 * 2 / n;
        xxyy += x * x * (1 - x * x * x) / 3 * 2 / n;
    }
    EXPECT_NEAR(g.xxy, xxy / 2, 1e-7);
    EXPECT_NEAR(g.xyy, xxy / 2, 1e-7);
    EXPECT_NEAR(g.xxyy, xxyy / 2, 1e-7);
}

// The four quarters of any shape add up to the whole.
TEST(CellGeometry, QuartersAddUp) {
    for (const Outline& outline :
         {shapes::l_shape(), shapes::annulus(), shapes::wall_with_window(), shapes::right_triangle()}) {
        std::vector<std::uint32_t> all(outline.triangles.size());
        std::iota(all.begin(), all.end(), 0u);
        const std::uint32_t middle = BREWSTER_UV_ONE / 2;
        double area = 0, first = 0;
        for (const std::uint32_t x : {0u, middle}) {
            for (const std::uint32_t y : {0u, middle}) {
                const Box<2> box = {{x, y}, {x + middle, y + middle}};
                const CellGeometry g = cell_geometry(outline, box, triangles_in(outline, box, all));
                area += g.area;
                first += g.area * (0.5 * g.mean[0] + (x == 0 ? -0.5 : 0.5));
            }
        }
        const CellGeometry g = whole(outline);
        EXPECT_NEAR(area, g.area, 1e-12);
        EXPECT_NEAR(first, g.area * g.mean[0], 1e-12);
    }
}

}  // namespace
}  // namespace brewster
