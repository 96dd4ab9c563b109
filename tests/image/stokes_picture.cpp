#include "image/stokes_picture.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(StokesPicture, ItsImageHoldsTheWorldThatIsAskedFor) {
    StokesPicture picture(2, 1);
    for (std::size_t plane = 0; plane < plane_count; ++plane) {
        const auto base = static_cast<float>(10 * plane);
        picture.light[plane][1] = {base + 1, base + 2, base + 3};
        picture.variance[plane][1] = {base + 4, base + 5, base + 6};
    }
    const Image on = stokes_image(picture, true), off = stokes_image(picture, false);
    for (int component = 0; component < 4; ++component) {
        for (int band = 0; band < 3; ++band) {
            const auto first = static_cast<float>(10 * component + band);
            EXPECT_EQ(on.channel(stokes_channel(component, band))[1], first + 1);
            EXPECT_EQ(on.channel(variance_channel(component, band))[1], first + 4);
            EXPECT_EQ(on.channel(stokes_channel(component, band))[0], 0);
            const auto unpolarized = static_cast<float>(40 + band);
            EXPECT_EQ(off.channel(stokes_channel(component, band))[1], component == 0 ? unpolarized + 1 : 0);
            EXPECT_EQ(off.channel(variance_channel(component, band))[1], component == 0 ? unpolarized + 4 : 0);
        }
    }
    EXPECT_EQ(on.channel_names(), off.channel_names());
}

}  // namespace
}  // namespace brewster
