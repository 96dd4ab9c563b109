#include "display/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <memory>
#include <random>

#include "base/error.h"
#include "bins/lookup.h"
#include "display/screen_pass.h"
#include "display/tone.h"
#include "gl_test.h"
#include "hand_made.h"

namespace brewster {
namespace {

constexpr float first_draw = 0.5f - 1.0f / 128;  ///< where in the pixel

/// A room of 2 m x 2 m x 2 m around the origin whose walls face inwards, floor first; a lamp hangs under the ceiling.
struct Room {
    Scene scene;
    std::uint32_t floor = 0, lamp = 0;

    Room() {
        Material grey;
        grey.albedo = {0.8f, 0.5f, 0.2f};
        const auto wall = [&](glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
            return hand_made::add_rectangle(scene, corner, u, v, grey);
        };
        floor = wall({-1, -1, 1}, {2, 0, 0}, {0, 0, -2});
        wall({-1, 1, -1}, {2, 0, 0}, {0, 0, 2});   // ceiling
        wall({-1, -1, -1}, {2, 0, 0}, {0, 2, 0});  // back
        wall({1, -1, 1}, {-2, 0, 0}, {0, 2, 0});   // front
        wall({-1, -1, 1}, {0, 0, -2}, {0, 2, 0});  // left
        wall({1, -1, -1}, {0, 0, 2}, {0, 2, 0});   // right
        Material light;
        light.albedo = glm::vec3(0.0f);
        light.emission = {10, 20, 30};
        lamp = hand_made::add_rectangle(scene, {-0.25f, 0.9f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f}, light);
        hand_made::close(scene);
    }
};

Camera camera_at(glm::vec3 position, glm::vec3 forward, glm::vec3 up) {
    Camera camera;
    camera.name = "eye";
    camera.position = position;
    camera.forward = forward;
    camera.up = up;
    camera.vertical_field_of_view = 2 * std::atan(1.0f);
    camera.near_distance = 0.01f;
    return camera;
}

class PictureTest : public GlTest {};

TEST_F(PictureTest, RadianceIsEmissionAndReflectedIrradiance) {
    const Room room;
    auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
    bins->nodes[bins->charts[room.floor].direct_root] = hand_made::add_leaf(*bins, {1, 3, 2, 4}, 0.3f);
    bins->nodes[bins->charts[room.floor].indirect_root] = hand_made::add_leaf(*bins, {2, 2, 2, 2}, 0.4f);
    Picture picture(room.scene);
    picture.show(bins);
    EXPECT_TRUE(picture.upload());
    // One metre above the floor, looking down, the upper edge of the picture is the far side of the floor: the picture
    // is the floor's rectangle, u to the right, v up, row 0 at v = 1.
    picture.look(camera_at({0, 0, 0}, {0, -1, 0}, {0, 0, -1}), 64, 64);
    picture.draw();
    const Image image = picture.stokes();
    const glm::vec3 albedo = room.scene.materials[0].albedo;
    for (const int y : {0, 20, 63}) {
        for (const int x : {0, 33, 63}) {
            const float u = (static_cast<float>(x) + first_draw) / 64,
                        v = 1 - (static_cast<float>(y) + first_draw) / 64;
            const float irradiance = 1 + 2 * u + v + 2;
            const auto pixel = static_cast<std::size_t>(64 * y + x);
            for (int band = 0; band < 3; ++band) {
                const float factor = band == 0 ? 1.0f : band == 1 ? 0.5f : 0.25f;
                const float expected = albedo[band] / hand_made::pi_f * irradiance * factor;
                EXPECT_NEAR(image.channel(stokes_channel(0, band))[pixel], expected, 2e-6f * expected);
                const float error = albedo[band] / hand_made::pi_f * 0.5f * factor;
                EXPECT_NEAR(image.channel(variance_channel(0, band))[pixel], error * error, 1e-5f * error * error);
                EXPECT_EQ(image.channel(stokes_channel(1, band))[pixel], 0);
            }
        }
    }
    picture.look(camera_at({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 65, 65);
    picture.draw(3);
    const Image up = picture.stokes();
    EXPECT_FLOAT_EQ(up.channel("S0.R")[65 * 32 + 32], 10);
    EXPECT_FLOAT_EQ(up.channel("S0.G")[65 * 32 + 32], 20);
    EXPECT_FLOAT_EQ(up.channel("S0.B")[65 * 32 + 32], 30);
    EXPECT_EQ(up.channel("S0.R")[0], 0);
}

/// One square of 2 m x 2 m around (0, 0, -2) that faces the origin and shines with the radiance 4, 2, 1.
Scene shining_square() {
    Scene scene;
    Material light;
    light.albedo = glm::vec3(0.0f);
    light.emission = {4, 2, 1};
    hand_made::add_rectangle(scene, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, light);
    hand_made::close(scene);
    return scene;
}

// The value at a pixel is that of the leaf where its ray meets the floor, seen at a slant: (u, v) are interpolated with
// perspective. Their float error of some 1e-6, times slopes of 10 over a leaf's tenth of the floor, stays below 2e-4.
TEST_F(PictureTest, CoordinatesFollowThePerspective) {
    const Room room;
    auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
    std::mt19937 random(5);
    ChartBins& floor_bins = bins->charts[room.floor];
    floor_bins.direct_root = hand_made::add_random_tree(*bins, 20, random);
    floor_bins.indirect_root = hand_made::add_random_tree(*bins, 7, random);
    const Camera camera = camera_at({0.3f, -0.2f, 0.9f}, glm::normalize(glm::vec3(-0.2f, -0.4f, -1.0f)),
                                    glm::normalize(glm::cross(glm::cross(glm::vec3(-0.2f, -0.4f, -1.0f), {0, 1, 0}),
                                                              glm::vec3(-0.2f, -0.4f, -1.0f))));
    const int width = 120, height = 80;
    Picture picture(room.scene);
    picture.show(bins);
    picture.upload();
    picture.look(camera, width, height);
    picture.draw();
    const Image image = picture.stokes();
    const Chart& floor = room.scene.charts[room.floor];
    int on_floor = 0, wrong = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 ray = ray_direction(camera, width, height, static_cast<float>(x) + first_draw,
                                                static_cast<float>(y) + first_draw);
            const glm::vec3 point = camera.position + ray * ((-1.0f - camera.position.y) / ray.y);
            const glm::vec2 unit = floor.unit_coordinates(point);
            if (ray.y >= 0 || glm::any(glm::lessThan(unit, glm::vec2(0.001f))) ||
                glm::any(glm::greaterThan(unit, glm::vec2(0.999f)))) {
                continue;
            }
            ++on_floor;
            const std::uint32_t u = lookup::fixed_point_of(unit.x), v = lookup::fixed_point_of(unit.y);
            const float irradiance = lookup::look_up(*bins, floor_bins.direct_root, 0u, u, v).value.x +
                                     lookup::look_up(*bins, floor_bins.indirect_root, 0u, u, v).value.x;
            const float expected = 0.8f / hand_made::pi_f * irradiance;
            const float shown = image.channel("S0.R")[static_cast<std::size_t>(width * y + x)];
            wrong += std::abs(shown - expected) > 2e-4f * expected;
        }
    }
    EXPECT_GT(on_floor, 3000);
    EXPECT_LE(wrong, on_floor / 1000);  // pixels whose point falls on a border of two leaves
}

// Edge pixels show the covered part of the pixel. At 45 degrees a picture of 101 x 101 sees 4 m at the distance of the
// square, whose edges then lie at pixel 25.25 and 75.75: the pixels of column 25 are covered by 3/4, which 64 draws in
// even columns find within 1/128; those of the corner by 9/16, where a net of 64 points is off by two points or so.
// The draws' variance is 64/63 p (1 - p) L^2 / 64, p the share they found.
TEST_F(PictureTest, DrawsAverageOverThePixel) {
    const Scene scene = shining_square();
    Picture picture(scene);
    picture.show(std::make_shared<Snapshot>(hand_made::empty_bins(scene)));
    picture.upload();
    picture.look(camera_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}), 101, 101);
    picture.draw(Picture::full_draws);
    const Image image = picture.stokes();
    const std::size_t edge = 101 * 50 + 25, inside = 101 * 50 + 50, outside = 101 * 50 + 10;
    EXPECT_NEAR(image.channel("S0.R")[edge], 4 * 0.75f, 4 * 1.01f / 128);
    const float share = image.channel("S0.R")[edge] / 4;
    EXPECT_NEAR(image.channel("V0.R")[edge], 16 * share * (1 - share) / 63, 1e-5f);
    EXPECT_FLOAT_EQ(image.channel("S0.G")[inside], 2);
    EXPECT_NEAR(image.channel("V0.G")[inside], 0, 1e-7f);
    EXPECT_EQ(image.channel("S0.R")[outside], 0);
    EXPECT_EQ(image.channel("V0.R")[outside], 0);
    const float corner = image.channel("S0.R")[101 * 25 + 25];
    EXPECT_NEAR(corner, 4 * 0.5625f, 4 * 2.0f / 64);
}

// The draws share the bins: their variance is averaged over the draws, not divided by them.
TEST_F(PictureTest, VarianceOfTheBinsDoesNotShrinkWithDraws) {
    const Room room;
    auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
    bins->nodes[bins->charts[room.floor].direct_root] = hand_made::add_leaf(*bins, {2, 2, 2, 2}, 0.5f);
    Picture picture(room.scene);
    picture.show(bins);
    picture.upload();
    picture.look(camera_at({0, 0, 0}, {0, -1, 0}, {0, 0, -1}), 16, 16);
    for (const int draws : {1, 15, 48}) {
        picture.draw(draws);
        const float error = 0.8f / hand_made::pi_f * 0.5f;
        EXPECT_NEAR(picture.stokes().channel("V0.R")[100], error * error, 1e-4f * error * error);
    }
    EXPECT_EQ(picture.draws(), 64);
}

TEST_F(PictureTest, OneLooksThroughAbsorbingBacksButNotThroughDoubleSidedWalls) {
    for (const bool double_sided : {false, true}) {
        Scene scene = shining_square();
        Material screen;
        hand_made::add_rectangle(scene, {-1, -1, -1}, {0, 2, 0}, {2, 0, 0}, screen, double_sided);  // faces away
        Picture picture(scene);
        picture.show(std::make_shared<Snapshot>(hand_made::empty_bins(scene)));
        picture.upload();
        picture.look(camera_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}), 9, 9);
        picture.draw();
        EXPECT_EQ(picture.stokes().channel("S0.R")[40], double_sided ? 0.0f : 4.0f);
    }
}

TEST_F(PictureTest, OldBinsStayUntilTheNewAreComplete) {
    const Room room;
    const Camera camera = camera_at({0, 0, 0}, {0, -1, 0}, {0, 0, -1});
    Picture picture(room.scene);
    picture.look(camera, 8, 8);
    picture.draw();
    EXPECT_EQ(picture.bins(), nullptr);
    EXPECT_EQ(picture.stokes().channel("S0.R")[0], 0);  // black before the first bins

    std::array<std::shared_ptr<Snapshot>, 3> bins;
    for (std::size_t k = 0; k < 3; ++k) {
        bins[k] = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
        bins[k]->version = k + 1;
        const float level = static_cast<float>(k + 1);
        bins[k]->nodes[bins[k]->charts[room.floor].direct_root] =
            hand_made::add_leaf(*bins[k], {level, level, level, level}, 0);
    }
    const auto shown = [&] {
        picture.draw();
        return picture.stokes().channel("S0.R")[0] * hand_made::pi_f / 0.8f;
    };
    picture.show(bins[0]);
    EXPECT_TRUE(picture.upload());
    EXPECT_EQ(picture.draws(), 0);
    EXPECT_FLOAT_EQ(shown(), 1);
    picture.show(bins[0]);  // the same version is not sent again
    EXPECT_TRUE(picture.uploaded());

    picture.show(bins[1]);
    EXPECT_FALSE(picture.upload(160));
    EXPECT_FLOAT_EQ(shown(), 1);
    picture.show(bins[2]);  // waits: what has begun is finished first
    int frames = 1;
    while (!picture.upload(160)) ++frames;
    EXPECT_GE(frames, 5);
    EXPECT_FLOAT_EQ(shown(), 2);
    EXPECT_FALSE(picture.uploaded());
    EXPECT_TRUE(picture.upload());
    EXPECT_FLOAT_EQ(shown(), 3);
    EXPECT_EQ(picture.bins()->version, 3u);
}

TEST_F(PictureTest, AnotherViewBeginsAnew) {
    const Scene scene = shining_square();
    Picture picture(scene);
    picture.show(std::make_shared<Snapshot>(hand_made::empty_bins(scene)));
    picture.upload();
    Camera camera = camera_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0});
    picture.look(camera, 8, 8);
    picture.draw(3);
    picture.look(camera, 8, 8);
    EXPECT_EQ(picture.draws(), 3);
    camera.position.x = 0.1f;
    picture.look(camera, 8, 8);
    EXPECT_EQ(picture.draws(), 0);
    picture.draw(3);
    picture.look(camera, 9, 8);
    EXPECT_EQ(picture.draws(), 0);
}

// The screen shows what the tone curve makes of the mean: the processor's and the shader's pow may round a code apart.
TEST_F(PictureTest, ScreenShowsTheToneMappedMean) {
    const Room room;
    auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
    bins->nodes[bins->charts[room.floor].direct_root] = hand_made::add_leaf(*bins, {0, 30, 1, 4}, 0);
    Picture picture(room.scene);
    picture.show(bins);
    picture.upload();
    picture.look(camera_at({0, 0, 0}, {0, -1, 0}, {0, 0, -1}), 50, 40);
    picture.draw(4);
    const Image image = picture.stokes();
    const Screen screen = Screen::off_screen(50, 40);
    Rendition dark;
    dark.exposure = -1.5f;
    ScreenPass().show(screen, picture.light(), dark);
    const ScreenImage pixels = screen.read();
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
        const glm::vec3 radiance(image.channel("S0.R")[i], image.channel("S0.G")[i], image.channel("S0.B")[i]);
        const glm::vec3 code = tone::screen_colour(radiance, -1.5f);
        for (int band = 0; band < 3; ++band) {
            ASSERT_NEAR(pixels.rgba[4 * i + static_cast<std::size_t>(band)], 255 * code[band], 1.0f) << i;
        }
        ASSERT_EQ(pixels.rgba[4 * i + 3], 255);
    }
}

TEST_F(PictureTest, SmallerPictureIsStretchedOverTheScreen) {
    const Scene scene = shining_square();
    Picture picture(scene);
    picture.show(std::make_shared<Snapshot>(hand_made::empty_bins(scene)));
    picture.upload();
    picture.look(camera_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}), 40, 40);
    picture.draw();
    const Screen screen = Screen::off_screen(80, 80);
    ScreenPass().show(screen, picture.light(), {});
    const ScreenImage pixels = screen.read();
    const auto red = [&](int x, int y) { return pixels.rgba[static_cast<std::size_t>(4 * (80 * y + x))]; };
    EXPECT_EQ(red(10, 40), 0);
    EXPECT_GT(red(24, 24), 200);
    EXPECT_GT(red(55, 55), 200);
    EXPECT_EQ(red(70, 40), 0);
}

TEST_F(PictureTest, DrawsInBandsAreTheSame) {
    const Scene scene = shining_square();
    const auto picture_of = [&] {
        auto picture = std::make_unique<Picture>(scene);
        picture->show(std::make_shared<Snapshot>(hand_made::empty_bins(scene)));
        picture->upload();
        picture->look(camera_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}), 40, 41);
        picture->draw();
        return picture;
    };
    const auto whole = picture_of(), banded = picture_of();
    whole->draw();
    const auto red = [](const Picture& picture) { return picture.stokes().channel(stokes_channel(0, 0)); };
    for (int band = 1; band <= 3; ++band) {
        EXPECT_EQ(banded->draws(), 1);
        banded->draw_band(3, {});
    }
    EXPECT_EQ(banded->draws(), 2);
    // Rows that have their third draw show it, the others two.
    const std::vector<float> second = red(*banded);
    EXPECT_EQ(second, red(*whole));
    banded->draw_band(3, {});
    whole->draw(1);
    const auto split = static_cast<std::ptrdiff_t>(40 * (41 - 14));  // 14 rows are a band, from below
    const std::vector<float> third = red(*whole), between = red(*banded);
    EXPECT_TRUE(std::equal(second.begin(), second.begin() + split, between.begin()));
    EXPECT_TRUE(std::equal(third.begin() + split, third.end(), between.begin() + split));
    EXPECT_NE(second, third);
    banded->draw(1);  // the rest of it
    EXPECT_EQ(banded->draws(), 3);
    EXPECT_EQ(red(*banded), third);
}

TEST_F(PictureTest, SizeBeyondTheDriverIsSaid) {
    const Scene scene = shining_square();
    Picture picture(scene);
    EXPECT_THROW(picture.look(Camera{}, 100000, 10), Error);
    EXPECT_THROW(picture.look(Camera{}, 0, 10), Error);
}

// A mirror takes what a glimpse holds of its own chart, wherever one of its texels is near; a wall never does; and once
// the glimpse is gone, both show their bins.
TEST_F(PictureTest, GlimpsesStandWhereBinsAreTooCoarse) {
    Scene scene;
    Material wall, mirror;
    wall.albedo = mirror.albedo = glm::vec3(0.0f);
    wall.emission = glm::vec3(1.0f);
    mirror.emission = glm::vec3(2.0f);
    mirror.base = Base::black;
    mirror.interface.kind = InterfaceKind::conductor;
    const std::uint32_t left = hand_made::add_rectangle(scene, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, wall);
    const std::uint32_t right = hand_made::add_rectangle(scene, {0, -1, 0}, {1, 0, 0}, {0, 2, 0}, mirror);
    hand_made::close(scene);
    Picture picture(scene);
    picture.show(std::make_shared<const Snapshot>(hand_made::empty_bins(scene)));
    picture.upload();
    picture.look(camera_at({0, 0, 1}, {0, 0, -1}, {0, 1, 0}), 8, 8);
    const auto radiance_at = [&](std::size_t column) {
        picture.draw();
        const Image image = picture.stokes();
        return image.channel(stokes_channel(0, 0))[8 * 3 + column];
    };
    EXPECT_FLOAT_EQ(radiance_at(1), 1);
    EXPECT_FLOAT_EQ(radiance_at(6), 2);
    // 4 x 4 texels; the light of each is its column.
    std::vector<std::uint32_t> chart;
    std::array<std::vector<glm::vec3>, plane_count> light;
    for (int p = 0; p < 16; ++p) {
        chart.push_back(p % 4 < 2 ? left : right);
        for (auto& plane : light) plane.emplace_back(static_cast<float>(10 + p % 4));
    }
    picture.show_glimpse(4, 4, chart, light);
    EXPECT_FLOAT_EQ(radiance_at(1), 1);
    EXPECT_NEAR(radiance_at(4), 12, 1e-3);     // not of the wall's texel beside it
    EXPECT_NEAR(radiance_at(5), 12.25, 1e-3);  // a quarter of a texel towards the next
    EXPECT_NEAR(radiance_at(7), 13, 1e-3);
    picture.clear_glimpse();
    EXPECT_FLOAT_EQ(radiance_at(6), 2);
}

}  // namespace
}  // namespace brewster
