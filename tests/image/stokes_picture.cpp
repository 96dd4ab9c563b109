#include "image/stokes_picture.h"

#include <gtest/gtest.h>

#include "base/error.h"

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

TEST(StokesPicture, FilesAreReadBack) {
    StokesPicture picture(1, 1);
    for (std::size_t plane = 0; plane < plane_count; ++plane) {
        picture.light[plane][0] = glm::vec3(static_cast<float>(plane + 1));
        picture.variance[plane][0] = glm::vec3(static_cast<float>(plane + 11));
    }
    const StokesPicture again = stokes_picture(stokes_image(picture, true));
    for (const Plane plane : {Plane::s0, Plane::s1, Plane::s2, Plane::s3}) {
        EXPECT_EQ(again.of(plane), picture.of(plane));
        EXPECT_EQ(again.variance_of(plane), picture.variance_of(plane));
    }
    EXPECT_EQ(again.of(Plane::unpolarized), picture.of(Plane::s0));
    EXPECT_THROW(stokes_picture(Image(1, 1)), Error);
}

}  // namespace
}  // namespace brewster
