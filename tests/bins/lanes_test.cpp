#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

// Quanta of a weight times a factor, as the C library rounds them; long double holds the products.
Quanta quanta_of_product(float weight, long double factor) {
    return std::llrint(std::ldexp(static_cast<long double>(weight) * factor, 30));
}

// Every number of both records against its definition in record.h; the rest of the records is left alone.
template <int D>
void expect_imprint(const RecordLayout<D>& layout, int fields, int first_field, int first_side) {
    using Layout = RecordLayout<D>;
    const int bands = layout.bands;
    for (std::uint32_t i = 0; i < 200; ++i) {
        std::vector<float> weights;
        for (int w = 0; w < fields * bands; ++w)
            weights.push_back(unit_float(philox(1, i, D, static_cast<std::uint32_t>(w))[0]) - 0.2f);
        std::array<float, 4> at{};
        for (std::size_t a = 0; a < D; ++a) at[a] = 2 * unit_float(philox(1, i, D, 50)[a]) - 1;
        if (i % 8 == 0) at[0] = 0;
        std::vector<Quanta> estimate(static_cast<std::size_t>(layout.estimate_size()), 7), expected_estimate = estimate;
        std::vector<Quanta> test(static_cast<std::size_t>(layout.test_size()), 7), expected_test = test;
        add_imprint<D>(weights.data(), at.data(), {fields, first_field, first_side, i % 8}, bands, estimate.data(),
                       test.data());

        const auto sign = [&](int a) { return at[static_cast<std::size_t>(a)] < 0 ? -1.0L : 1.0L; };
        const auto square = [&](int a) {  // rounded as a double is
            const double x = at[static_cast<std::size_t>(a)];
            return static_cast<long double>(1.5 * x * x - 0.5);
        };
        for (int channel = 0; channel < fields * bands; ++channel) {
            Quanta* row =
                &expected_estimate[static_cast<std::size_t>((first_field * bands + channel) * Layout::estimate_stride)];
            const float w = weights[static_cast<std::size_t>(channel)];
            *row++ += quanta_of_product(w, 1);
            for (std::size_t a = 0; a < D; ++a) *row++ += quanta_of_product(w, static_cast<long double>(at[a]));
            *row += quanta_of_product(w, static_cast<long double>(w));
        }
        for (int field = 0; field < fields; ++field) {
            float mean = 0;
            for (int band = 0; band < bands; ++band) mean += weights[static_cast<std::size_t>(field * bands + band)];
            mean *= 1.0f / static_cast<float>(bands);
            const auto add = [&](int place, long double factor) {
                expected_test[static_cast<std::size_t>(place)] += quanta_of_product(mean, factor);
            };
            const int side = Layout::sides + (first_side + field - 1) * Layout::side_stride;
            for (int a = 0; a < D; ++a) {
                if (field == 0) add(Layout::moments + a, static_cast<long double>(at[static_cast<std::size_t>(a)]));
                add(field == 0 ? Layout::legendre + a : side + a, square(a));
                add(field == 0 ? Layout::signs + a : side + D + a, sign(a));
            }
            if (field > 0) continue;
            int pair = Layout::products;
            for (int a = 0; a < D; ++a)
                for (int b = a + 1; b < D; ++b) add(pair++, sign(a) * sign(b));
            add(Layout::squares, static_cast<long double>(mean));
            add(Layout::replicas + static_cast<int>(i % 8), 1);
        }
        EXPECT_EQ(estimate, expected_estimate);
        EXPECT_EQ(test, expected_test);
    }
}

TEST(Imprint, AddsEveryNumberOfTheRecords) {
    expect_imprint<4>(GlossFields{3, 3}.layout(), 4, 0, 0);
    expect_imprint<4>(GlossFields{3, 4}.layout(), 5, 0, 0);
    expect_imprint<4>(GlossFields{1, 1}.layout(), 1, 0, 0);
    expect_imprint<2>(EntryFields{3, 2, 2}.layout(), 2, 2, 1);
    expect_imprint<2>(EntryFields{3, 1, 2}.layout(), 1, 0, 0);
    expect_imprint<2>(EntryFields{1, 1, 1}.layout(), 1, 1, 0);
}

}  // namespace
}  // namespace brewster
