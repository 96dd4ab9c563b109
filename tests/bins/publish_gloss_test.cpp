#include "bins/publish_gloss.h"

#include <gtest/gtest.h>

#include "base/philox.h"
#include "bins/file_event.h"
#include "shapes.h"

namespace brewster {
namespace {

/// What is published of a square after `photons`, which `file(i, point, weights)` places and weighs one by one.
template <class File>
GlossBins published(const GlossFields& fields, std::uint64_t photons, const File& file) {
    const BinSettings settings;
    const RecordLayout<4> layout = fields.layout();
    BinTree<4> tree({shapes::rectangle(1, 1)}, layout, settings);
    Tally<4> tally(layout);
    tally.resize(tree.leaf_count());
    for (std::uint64_t i = 0; i < photons; ++i) {
        BinTree<4>::Point point;
        std::array<float, 12> weights{};
        file(i, point, weights);
        const auto used = static_cast<std::size_t>(3 * layout.fields);
        file_event<4>(tree, tally, tree.locate(0, point), point,
                      {0, 0, std::span<const float>(weights).first(used), philox(6, i, 0, 0)[0] % 8});
    }
    tree.absorb(tally);
    return publish_gloss(tree, fields, nullptr, photons, glm::dvec3(1), settings);
}

/// One cell of light that falls to a twentieth across it and is polarized by the same share everywhere: so must what is
/// published of it be, in every corner, however steep it is.
TEST(PublishGloss, AConstantShareOfPolarizationStaysOne) {
    constexpr float share = 0.9f;
    GlossFields fields;
    fields.components = 3;
    const GlossBins bins = published(fields, 4000, [](std::uint64_t i, BinTree<4>::Point& point, auto& weights) {
        const auto words = philox(3, i, 0, 0);
        for (std::size_t a = 0; a < 4; ++a) point[a] = words[a] >> 8;
        const float light = std::exp(-3 * unit_float(words[0]));
        std::fill_n(weights.begin(), 3, light);  // S0, S1, S2, S0 of the other world, three bands each
        std::fill_n(weights.begin() + 3, 3, share * light);
        std::fill_n(weights.begin() + 9, 3, light);
    });
    const std::size_t texels = BREWSTER_GLOSS_FIELD_TEXELS;
    ASSERT_EQ(bins.leaves.size() % (4 * texels), 0u);
    for (std::size_t leaf = 0; leaf < bins.leaf_count(); ++leaf) {
        const glm::vec4* s0 = &bins.leaves[leaf * 4 * texels];
        EXPECT_GT(std::abs(s0[1].x), 0.5f * s0[0].x);  // steep enough to be limited by itself
        for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(s0[texels + k].x, share * s0[k].x, 2e-3f * s0[0].x) << k;
    }
}

/// The error of the one cell that a few photons make, relative to its value. They come from the whole of it, or from a
/// twentieth of each coordinate around .4, where no leaf has been split yet: the same number, so the same noise.
float relative_error_of_cell(bool peak) {
    const GlossBins bins = published(GlossFields{}, 100, [&](std::uint64_t i, BinTree<4>::Point& point, auto& weights) {
        const auto words = philox(5, i, 0, 0);
        for (std::size_t a = 0; a < 4; ++a) {
            const float unit = unit_float(words[a]);
            point[a] = static_cast<std::uint32_t>((peak ? 0.4f + 0.05f * unit : unit) * 0x1p24f);
        }
        std::fill_n(weights.begin(), 3, 1.0f);
    });
    EXPECT_EQ(bins.leaf_count(), 1u);
    return bins.leaves[0].w / (bins.leaves[0].x + 0.2f * (bins.leaves[1].x + bins.leaves[2].x));
}

/// What a cell without any split below it leaves out is known from its own test.
TEST(PublishGloss, APeakWithinACellIsInItsError) {
    const float even = relative_error_of_cell(false);
    EXPECT_GT(even, 0.05f);
    EXPECT_LT(even, 0.2f);
    EXPECT_GT(relative_error_of_cell(true), 2 * even);
}

}  // namespace
}  // namespace brewster
