#include "bins/tree.h"

#include <gtest/gtest.h>

#include <random>

#include "filing.h"
#include "shapes.h"

namespace brewster {
namespace {

BinSettings one_root() {
    BinSettings settings;
    settings.fixed_grid_log2 = 0;
    return settings;
}

TEST(BinTree, FixedGridHasEqualCells) {
    BinSettings settings;
    settings.fixed_grid_log2 = 4;
    const BinTree<2> tree({shapes::rectangle(1, 2)}, {}, settings);
    EXPECT_EQ(tree.leaf_count(), 256u);
    for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
        if (tree.node(node).is_leaf()) {
            EXPECT_NEAR(tree.cell(node).geometry.area, 2.0 / 256, 1e-12);
        }
    }
}

TEST(BinTree, LocateFindsTheLeafThatHoldsThePoint) {
    BinTree<2> tree({shapes::l_shape(), shapes::rectangle(1, 1)}, {}, BinSettings{});
    std::mt19937 random(7);
    std::vector<const Cell<2>*> cell_of_leaf(tree.leaf_count());
    for (std::uint32_t node = 0; node < tree.node_count(); ++node)
        if (tree.node(node).is_leaf()) cell_of_leaf[tree.node(node).leaf()] = &tree.cell(node);
    for (int i = 0; i < 10000; ++i) {
        const std::uint32_t chart = random() % 2;
        const BinTree<2>::Point point = {static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE),
                                         static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE)};
        const std::uint32_t leaf = tree.locate(chart, point);
        const Cell<2>& cell = *cell_of_leaf[leaf];
        EXPECT_EQ(cell.chart, chart);
        for (std::size_t a = 0; a < 2; ++a) {
            EXPECT_GE(point[a], cell.box.low[a]);
            EXPECT_LT(point[a], cell.box.high[a]);
            EXPECT_LE(std::abs(tree.frame(leaf).coordinate(point[a], a)), 1.0f);
        }
    }
}

TEST(BinTree, NoCellIsWithoutSurface) {
    for (const Outline& outline :
         {shapes::l_shape(), shapes::annulus(), shapes::wall_with_window(), shapes::right_triangle()}) {
        const BinTree<2> tree({outline}, {}, BinSettings{});
        double area = 0;
        for (std::uint32_t node = 0; node < tree.node_count(); ++node) {
            EXPECT_GT(tree.cell(node).geometry.area, 0);
            if (tree.node(node).is_leaf()) area += tree.cell(node).geometry.area;
        }
        EXPECT_NEAR(area, tree.cell(0).geometry.area, 1e-9);
        EXPECT_GT(tree.leaf_count(), 64u);
    }
}

TEST(BinTree, FirstBordersLieOnContactLines) {
    Outline outline = shapes::rectangle(1, 1);
    outline.contacts.emplace_back(glm::dvec2(0.3, 0.1), glm::dvec2(0.3, 0.9));
    outline.contacts.emplace_back(glm::dvec2(0.2, 0.4), glm::dvec2(0.7, 0.6));  // oblique: no border can follow it
    const BinTree<2> tree({outline}, {}, BinSettings{});
    EXPECT_EQ(tree.node(0).axis(), 0u);
    EXPECT_NEAR(tree.node(0).split, 0.3 * BREWSTER_UV_ONE, 1);
}

TEST(BinTree, BudgetStopsSplits) {
    BinSettings settings = one_root();
    BinTree<2> tree({shapes::rectangle(1, 1)}, {}, settings);
    settings.fixed_grid_log2 = -1;
    settings.memory_bytes = tree.bytes() * 7;  // the root and three splits of two nodes
    Tally<2> tally;
    std::mt19937 random(1);
    for (std::uint64_t batch = 1; batch < 12; ++batch) {
        tally.resize(tree.leaf_count());
        for (int i = 0; i < 4000; ++i) {
            const BinTree<2>::Point point = {static_cast<std::uint32_t>(random() % (BREWSTER_UV_ONE / 8)),
                                             static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE)};
            file_light<2>(tree, tally, tree.locate(0, point), point, glm::vec3(1), true, random() % 8);
        }
        tree.absorb(tally);
        tree.split_leaves(4000 * batch, settings);
    }
    EXPECT_EQ(tree.node_count(), 7u);
}

TEST(BinTree, SumsAreThoseOfTheEvents) {
    BinTree<2> tree({shapes::rectangle(1, 1)}, {}, one_root());
    Tally<2> tally;
    tally.resize(tree.leaf_count());
    const BinTree<2>::Point point = {3 * (BREWSTER_UV_ONE / 4), BREWSTER_UV_ONE / 4};  // x = 0.5, y = -0.5
    file_light<2>(tree, tally, 0, point, {3.0f, 1.5f, 0.75f}, true, 5);
    file_light<2>(tree, tally, 0, point, {1.0f, 1.0f, 1.0f}, false, 2);
    tree.absorb(tally);
    using Layout = RecordLayout<2>;
    const CellSums sums = tree.sums(0);
    const auto estimate = [&](int channel, int row) {
        return to_weight(sums.estimate[static_cast<std::size_t>(channel * Layout::estimate_stride + row)]);
    };
    EXPECT_EQ(estimate(0, 0), 3.0);
    EXPECT_EQ(estimate(1, 1), 0.75);
    EXPECT_EQ(estimate(1, 2), -0.75);
    EXPECT_EQ(estimate(2, 3), 0.5625);
    EXPECT_EQ(estimate(3, 0), 1.0);
    EXPECT_EQ(to_weight(sums.test[Layout::replicas + 5]), 1.75);
    EXPECT_EQ(to_weight(sums.test[Layout::replicas + 2]), 1.0);
    EXPECT_EQ(to_weight(sums.test[Layout::products]), -2.75);
    EXPECT_EQ(to_weight(sums.test[Layout::signs]), 2.75);
    // Handed over means gone from the tally.
    tree.absorb(tally);
    EXPECT_EQ(to_weight(tree.sums(0).estimate[0]), 3.0);
}

// Four dimensions: an even field keeps its root whole, a field that shears across position and direction does not,
// though each of its axes alone looks even.
TEST(BinTree, FourDimensionsSeeShear) {
    for (const bool shear : {false, true}) {
        BinSettings settings = one_root();
        BinTree<4> tree({shapes::rectangle(1, 1)}, {}, settings);
        settings.fixed_grid_log2 = -1;
        settings.split_z_squared = 20;  // chance of one of 14 tests below 1e-4
        Tally<4> tally;
        tally.resize(tree.leaf_count());
        std::mt19937 random(3);
        for (int i = 0; i < 5000; ++i) {
            BinTree<4>::Point point;
            for (std::uint32_t& x : point) x = static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE);
            if (shear) point[2] = (point[2] / 2 + (point[0] < BREWSTER_UV_ONE / 2 ? 0 : BREWSTER_UV_ONE / 2));
            file_light<4>(tree, tally, 0, point, glm::vec3(1), false, random() % 8);
        }
        tree.absorb(tally);
        tree.split_leaves(5000, settings);
        EXPECT_EQ(tree.leaf_count(), shear ? 2u : 1u);
    }
}

// The main light is even; a side field steps at the middle, or is even as well: only the step splits the root.
TEST(BinTree, SideFieldsCanAskForASplit) {
    const EntryFields fields{band_count, 1, 2};
    for (const bool step : {false, true}) {
        BinSettings settings = one_root();
        BinTree<2> tree({shapes::rectangle(1, 1)}, fields.layout(), settings);
        settings.fixed_grid_log2 = -1;
        settings.split_z_squared = 20;
        Tally<2> tally(fields.layout());
        tally.resize(tree.leaf_count());
        std::mt19937 random(3);
        for (int i = 0; i < 5000; ++i) {
            BinTree<2>::Point point;
            for (std::uint32_t& x : point) x = static_cast<std::uint32_t>(random() % BREWSTER_UV_ONE);
            const float side = step && point[1] > BREWSTER_UV_ONE / 2 ? 0.0f : 1.0f;
            const std::array<float, 6> weights = {1, 1, 1, side, side, side};
            file_event<2>(tree, tally, 0, point, {fields.field(1, 0), 0, weights, static_cast<std::uint32_t>(i % 8)});
        }
        tree.absorb(tally);
        tree.split_leaves(5000, settings);
        EXPECT_EQ(tree.node_count(), step ? 3u : 1u);
        if (step) {
            EXPECT_EQ(tree.node(0).axis(), 1u);
        }
    }
}

}  // namespace
}  // namespace brewster
