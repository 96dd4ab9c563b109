#include "scene/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace brewster {
namespace {

TEST(BoxTree, FindsWhatAFullSearchFinds) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto random_box = [&](float size) {
        const glm::vec3 low(unit(engine), unit(engine), unit(engine));
        return Box{low, low + size * glm::vec3(unit(engine), unit(engine), unit(engine))};
    };
    for (const std::size_t count : {0u, 1u, 5u, 500u}) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < count; ++i) boxes.push_back(random_box(0.1f));
        const BoxTree tree(boxes);
        std::size_t found = 0;
        for (int query = 0; query < 200; ++query) {
            const Box wanted = random_box(0.3f);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < count; ++i) {
                bool meets = true;
                for (int k = 0; k < 3; ++k)
                    meets = meets && boxes[i].low[k] <= wanted.high[k] && wanted.low[k] <= boxes[i].high[k];
                if (meets) expected.push_back(i);
            }
            EXPECT_EQ(tree.overlapping(wanted), expected);
            found += expected.size();
        }
        EXPECT_TRUE(count < 500 || found > count);
    }
}

TEST(BoxTree, BoxesThatTouchOverlap) {
    const BoxTree tree({{glm::vec3(0), glm::vec3(1)}});
    EXPECT_EQ(tree.overlapping({{1, 0, 0}, {2, 1, 1}}).size(), 1u);
    EXPECT_EQ(tree.overlapping({{1.001f, 0, 0}, {2, 1, 1}}).size(), 0u);
}

}  // namespace
}  // namespace brewster
