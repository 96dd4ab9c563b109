#include "gather/glimpse.h"

#include <gtest/gtest.h>

#include "gather/gather_test.h"
#include "reference/hand_made.h"
#include "scene/test_materials.h"

namespace brewster {
namespace {

// What a glimpse says of a pixel is what the first draw of a whole picture says, to the bit, whatever the threads; and
// it says it of exactly those surfaces that bins cannot show.
TEST(Glimpse, IsTheFirstDrawWhereBinsAreTooCoarse) {
    const auto scene = scene_of_assets("brewster-room");  // floor and sides of m = .04, walls without gloss
    const auto bins = solved_bins(scene, 20'000);
    const Camera& camera = scene->cameras.front();
    Glimpse glimpse(scene);
    ASSERT_TRUE(glimpse.any());
    const GlimpsePicture seen = glimpse.see(*bins, camera, 61, 40, 2);
    const StokesPicture whole = gathered(scene, bins, camera, 61, 40, 1);
    std::size_t beyond = 0, different = 0, between = 0;
    for (std::size_t p = 0; p < whole.pixel_count(); ++p) {
        if (seen.chart[p] == no_chart) {
            between += whole.light[0][p] != glm::vec3(0.0f);
            EXPECT_EQ(seen.light[0][p], glm::vec3(0.0f));
            continue;
        }
        ++beyond;
        EXPECT_TRUE(scene->materials[scene->charts[seen.chart[p]].material].beyond_bins());
        for (std::size_t plane = 0; plane < plane_count; ++plane)
            different += seen.light[plane][p] != whole.light[plane][p];
    }
    EXPECT_EQ(beyond, seen.followed);
    EXPECT_GT(beyond, 200u);
    EXPECT_GT(between, 200u);
    EXPECT_EQ(different, 0u);
    const GlimpsePicture alone = glimpse.see(*bins, camera, 61, 40, 1);
    EXPECT_EQ(alone.chart, seen.chart);
    EXPECT_EQ(alone.light, seen.light);
}

TEST(Glimpse, NothingIsBeyondBinsOfWallsAndWideGloss) {
    EXPECT_FALSE(Glimpse(scene_of_assets("cornell-box")).any());
    Material gloss = test_materials::dielectric(Base::black, glm::vec3(1.5f));
    EXPECT_TRUE(gloss.beyond_bins());
    gloss.interface.finish = Finish::beckmann;
    gloss.interface.slope = 0.1f;
    EXPECT_FALSE(gloss.beyond_bins());
    gloss.interface.slope = 0.05f;
    EXPECT_TRUE(gloss.beyond_bins());
}

}  // namespace
}  // namespace brewster
