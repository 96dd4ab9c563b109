#include <gtest/gtest.h>

#include "base/philox.h"
#include "bins/bottom_up.h"
#include "bins/file_event.h"
#include "bins/publish.h"
#include "bins/publish_gloss.h"
#include "shapes.h"

namespace brewster {
namespace {

constexpr std::uint64_t photons_per_batch = 12000;
constexpr std::uint32_t charts = 40;

template <int D>
struct Grown {
    BinTree<D> tree;
    Tally<D> pending;  // half a batch more
    std::uint64_t photons = 0;
    BinSettings settings;
};

// Forty charts, the first with half of the light, split until there are some ten thousand nodes.
template <int D>
Grown<D> grown(const RecordLayout<D>& layout, unsigned threads) {
    BinSettings settings;
    settings.split_z_squared = 0;
    settings.split_photons = 1;
    Grown<D> grown{BinTree<D>(std::vector<Outline>(charts, shapes::rectangle(1, 1)), layout, settings),
                   Tally<D>(layout), 0, settings};
    std::vector<Tally<D>> own;
    for (unsigned thread = 0; thread < threads; ++thread) own.emplace_back(layout);
    std::vector<Tally<D>*> tallies;
    for (Tally<D>& tally : own) tallies.push_back(&tally);
    constexpr std::uint64_t batches = D == 2 ? 1 : 8;
    for (std::uint64_t batch = 0; batch <= batches; ++batch) {
        for (Tally<D>& tally : own) tally.resize(grown.tree.leaf_count());
        const std::uint64_t count = batch == batches ? photons_per_batch / 2 : photons_per_batch;
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto words = philox(batch, i, 0, 0);
            typename BinTree<D>::Point point;
            for (std::size_t a = 0; a < D; ++a) point[a] = words[a] >> 8;
            const std::array<float, 3> weights = {1, 0.5f + unit_float(words[0]), unit_float(words[1])};
            const std::uint32_t chart = i % 2 == 0 ? 0 : static_cast<std::uint32_t>(i / 2) % charts;
            file_event<D>(grown.tree, own[i % threads], grown.tree.locate(chart, point), point,
                          {D == 2 && i % 3 == 0 ? 1 : 0, 0, weights, static_cast<std::uint32_t>(i % 8)});
        }
        grown.photons += count;
        if (batch == batches) break;
        grown.tree.absorb(tallies, threads);
        grown.tree.split_leaves(grown.photons, settings, 0, threads);
    }
    grown.pending.resize(grown.tree.leaf_count());
    grown.pending.take(tallies, threads);
    return grown;
}

template <int D>
std::string bytes_of(const Grown<D>& grown) {
    ByteWriter file;
    grown.tree.write(file);
    grown.pending.write(file);
    return file.bytes();
}

TEST(BinThreads, TreesAndWhatIsPublishedAreTheSameForAnyNumber) {
    const Grown<2> one = grown<2>({}, 1);
    EXPECT_GT(one.tree.node_count(), 8000u);
    const Snapshot published = publish(one.tree, {}, &one.pending, one.photons, glm::dvec3(1, 2, 3), one.settings, 1);
    const Grown<2> three = grown<2>({}, 3);
    ASSERT_EQ(bytes_of(three), bytes_of(one));
    const Snapshot again = publish(three.tree, {}, &three.pending, one.photons, glm::dvec3(1, 2, 3), one.settings, 3);
    EXPECT_EQ(again.nodes, published.nodes);
    EXPECT_EQ(again.leaves, published.leaves);
    EXPECT_EQ(again.relative_error, published.relative_error);
}

TEST(BinThreads, SoIsGloss) {
    const Grown<4> one = grown<4>({}, 1);
    EXPECT_GT(one.tree.node_count(), 8000u);
    const GlossBins published = publish_gloss(one.tree, {}, &one.pending, one.photons, glm::dvec3(1), one.settings, 1);
    const Grown<4> three = grown<4>({}, 3);
    ASSERT_EQ(bytes_of(three), bytes_of(one));
    const GlossBins again = publish_gloss(three.tree, {}, &three.pending, one.photons, glm::dvec3(1), one.settings, 3);
    EXPECT_EQ(again.nodes, published.nodes);
    EXPECT_EQ(again.leaves, published.leaves);
    EXPECT_EQ(again.roots, published.roots);
}

TEST(BinThreads, NodesComeOnceAndAfterTheirChildren) {
    const BinTree<2> tree(std::vector<Outline>(charts, shapes::rectangle(1, 1)), {}, BinSettings{});
    EXPECT_GT(tree.node_count(), 8000u);
    for (const unsigned threads : {1u, 3u}) {
        std::vector<int> visits(tree.node_count());
        std::vector<std::uint32_t> below(tree.node_count());
        BottomUp<2>(tree, threads).visit([&](std::uint32_t node) {
            ++visits[node];
            below[node] = 1;
            if (tree.node(node).is_leaf()) return;
            for (const std::uint32_t side : {0u, 1u}) below[node] += below[tree.node(node).low_child() + side];
        });
        EXPECT_EQ(visits, std::vector<int>(tree.node_count(), 1));
        std::uint64_t all = 0;
        for (std::uint32_t chart = 0; chart < tree.chart_count(); ++chart) all += below[chart];
        EXPECT_EQ(all, tree.node_count());
    }
}

TEST(BinThreads, TalliesKnowWhatWasTouched) {
    BinTree<2> tree({shapes::rectangle(1, 1)}, {}, BinSettings{});
    Tally<2> tally;
    tally.resize(tree.leaf_count());
    const BinTree<2>::Point point = {BREWSTER_UV_ONE / 3, BREWSTER_UV_ONE / 3};
    const std::uint32_t leaf = tree.locate(0, point);
    EXPECT_FALSE(tally.touched(leaf));
    const std::array<float, 3> weights = {1, 1, 1};
    file_event<2>(tree, tally, leaf, point, {0, 0, weights, 0});
    for (std::uint32_t other = 0; other < tree.leaf_count(); ++other) EXPECT_EQ(tally.touched(other), other == leaf);
    tree.absorb(tally);
    EXPECT_FALSE(tally.touched(leaf));
    EXPECT_EQ(tally.estimate(leaf)[0], 0);
}

}  // namespace
}  // namespace brewster
