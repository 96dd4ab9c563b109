#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"
#include "bins/direction_map.h"
#include "bins/file_event.h"
#include "shapes.h"

namespace brewster {
namespace {

TEST(DirectionMap, WithoutBranchesItIsTheShadersFormula) {
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const auto words = philox(1, i, 0, 0);
        float x = 2 * unit_float(words[0]) - 1, y = 2 * unit_float(words[1]) - 1;
        if (i % 16 == 0) x = 0;
        if (i % 32 == 0) y = 0;
        if (i % 16 == 1) y = x;
        if (i % 16 == 2) y = -x;
        const glm::vec2 formula = direction_map::direction_square({x, y});
        const auto alone = direction_map::direction_square_of(x, y);
        const auto lanes = direction_map::direction_square_of(FloatLanes(x), FloatLanes(y));
        EXPECT_EQ(alone.x, formula.x) << x << " " << y;
        EXPECT_EQ(alone.y, formula.y) << x << " " << y;
        EXPECT_EQ(static_cast<float>(lanes.x[0]), formula.x);
        EXPECT_EQ(static_cast<float>(lanes.y[7]), formula.y);
    }
}

// A tree of three charts, split at random places until it has hundreds of leaves.
template <int D>
BinTree<D> grown_tree(const RecordLayout<D>& layout) {
    BinSettings settings;
    settings.split_z_squared = 0;
    settings.split_photons = 1;
    BinTree<D> tree({shapes::rectangle(1, 1), shapes::rectangle(2, 1), shapes::rectangle(1, 3)}, layout, settings);
    for (std::uint64_t batch = 0; batch < 6; ++batch) {
        Tally<D> tally(layout);
        tally.resize(tree.leaf_count());
        for (std::uint64_t i = 0; i < 3000; ++i) {
            const auto words = philox(batch, i, 0, 0);
            typename BinTree<D>::Point point;
            for (std::size_t a = 0; a < D; ++a) point[a] = words[a] >> 8;
            const std::array<float, 3> weights = {1, 1, unit_float(words[0])};
            file_event<D>(tree, tally, tree.locate(static_cast<std::uint32_t>(i % 3), point), point,
                          {0, 0, weights, static_cast<std::uint32_t>(i % 8)});
        }
        tree.absorb(tally);
        tree.split_leaves(3000 * (batch + 1), settings);
    }
    return tree;
}

template <int D>
void expect_same_descent() {
    const BinTree<D> tree = grown_tree<D>({});
    EXPECT_GT(tree.leaf_count(), 150u);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        std::array<std::uint32_t, lane_count> chart, leaves;
        std::array<std::array<std::uint32_t, lane_count>, D> columns;
        std::array<typename BinTree<D>::Point, lane_count> points;
        for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
            const auto words = philox(77, i, lane, 0);
            chart[lane] = static_cast<std::uint32_t>((i + lane) % 3);
            for (std::size_t a = 0; a < D; ++a) columns[a][lane] = points[lane][a] = words[a] >> 8;
        }
        std::array<WordLanes, D> point;
        for (std::size_t a = 0; a < D; ++a) point[a] = load_words(columns[a].data());
        const WordLanes leaf = tree.descend(tree.enter(load_words(chart.data()), point[0], point[1]), point);
        store(leaf, leaves.data());
        const std::array<FloatLanes, D> place = leaf_coordinates<D>(tree, leaf, point);
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            ASSERT_EQ(leaves[lane], tree.locate(chart[lane], points[lane]));
            for (std::size_t a = 0; a < D; ++a)
                ASSERT_EQ(static_cast<float>(place[a][lane]), tree.frame(leaves[lane]).coordinate(points[lane][a], a));
        }
    }
}

TEST(BinTree, LanesDescendWhereOnePhotonDoes) {
    expect_same_descent<2>();
    expect_same_descent<4>();
}

// Lanes and one photon add the same quanta to the same places of both records.
TEST(Imprint, LanesFileWhatOnePhotonFiles) {
    constexpr int fields = 4, bands = 3;
    const RecordLayout<4> layout = GlossFields{bands, 3}.layout();
    const auto estimates = static_cast<std::size_t>(layout.estimate_size()),
               tests = static_cast<std::size_t>(layout.test_size());
    for (std::uint64_t i = 0; i < 200; ++i) {
        std::array<FloatLanes, fields * bands> weights;
        std::array<FloatLanes, 4> place;
        for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
            for (std::uint32_t w = 0; w < weights.size(); ++w)
                weights[w][lane] = unit_float(philox(1, i, lane, w)[0]) - 0.2f;
            for (std::size_t a = 0; a < 4; ++a) place[a][lane] = 2 * unit_float(philox(1, i, lane, 50)[a]) - 1;
        }
        Imprint<FloatLanes, 4, fields, bands> lanes;
        make_imprint(weights.data(), fields, bands, place, lanes);
        for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
            std::array<float, fields * bands> own;
            for (std::size_t w = 0; w < own.size(); ++w) own[w] = weights[w][lane];
            Imprint<float, 4, fields, bands> alone;
            make_imprint(own.data(), fields, bands,
                         std::array<float, 4>{place[0][lane], place[1][lane], place[2][lane], place[3][lane]}, alone);
            std::vector<float> row;
            for (const FloatLanes& x : lanes.x) row.push_back(x[lane]);
            const ImprintPlace where{fields, 0, 0, lane};
            std::vector<Quanta> estimate(estimates), other_estimate(estimates), test(tests), other_test(tests);
            add_imprint<4, fields, bands>(row.data(), where, bands, estimate.data(), test.data());
            add_imprint<4, fields, bands>(alone.x.data(), where, bands, other_estimate.data(), other_test.data());
            EXPECT_EQ(estimate, other_estimate);
            EXPECT_EQ(test, other_test);
            EXPECT_NE(test[static_cast<std::size_t>(RecordLayout<4>::replicas) + lane], 0);
        }
    }
}

}  // namespace
}  // namespace brewster
