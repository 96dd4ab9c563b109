#include "display/albedo_textures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "display/picture.h"
#include "gl_test.h"
#include "hand_made.h"
#include "scene/albedo.h"

namespace brewster {
namespace {

using Color = std::array<std::uint8_t, 4>;

template <class Pixel>
SurfaceTexture texture_of(int width, int height, const Pixel& pixel, bool nearest) {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t byte : Color(pixel(x, y))) texels.push_back(byte);
    SurfaceTexture texture;
    texture.width = width;
    texture.height = height;
    texture.texels = std::make_shared<const std::vector<std::uint8_t>>(std::move(texels));
    texture.nearest = nearest;
    return texture;
}

// A textured square of 2 m that looks along +z, in front of a wall without a texture.
struct Board {
    Scene scene;

    explicit Board(SurfaceTexture texture, float cutoff = 0) {
        Material paint;
        paint.albedo = glm::vec3(1.0f);
        paint.texture = 0;
        paint.alpha_cutoff = cutoff;
        hand_made::add_rectangle(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, paint);
        scene.texture_coordinates = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        Material wall;
        wall.albedo = {0.25f, 0.5f, 0.75f};
        hand_made::add_rectangle(scene, {-9, -9, -0.5f}, {18, 0, 0}, {0, 18, 0}, wall);
        scene.texture_coordinates.resize(8);
        scene.textures.push_back(std::move(texture));
        hand_made::close(scene);
    }

    // Even light of irradiance pi: radiance is albedo (times 1, 1/2, 1/4).
    std::shared_ptr<const Snapshot> even_light() const {
        auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(scene));
        for (const ChartBins& chart : bins->charts)
            bins->nodes[chart.direct_root] =
                hand_made::add_leaf(*bins, {hand_made::pi_f, hand_made::pi_f, hand_made::pi_f, hand_made::pi_f}, 0);
        return bins;
    }
};

// Sees the board fill the picture.
Camera facing_camera() {
    Camera camera;
    camera.position = {0, 0, 3};
    camera.forward = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.vertical_field_of_view = 2 * std::atan(1.0f / 3.0f);
    camera.near_distance = 0.01f;
    return camera;
}

Image picture_of(const Board& board, const Camera& camera, int side, int draws) {
    Picture picture(board.scene);
    picture.show(board.even_light());
    picture.upload();
    picture.look(camera, side, side);
    picture.draw(draws);
    return picture.stokes();
}

class AlbedoTexturesTest : public GlTest {};

// 512 x 512 texels in checks of 32, dark 0.0185 and light 0.7605. On 400 pixels a check is 25 wide, so that its edges
// lie on pixels' borders; on 300 they are at 18.75, in their midst. No edge may blur more than the pixel it runs
// through, or, between texels that are interpolated, one more.
TEST_F(AlbedoTexturesTest, CheckerboardStaysSharpAndKeepsItsMean) {
    const auto checks = [](int x, int y) {
        const std::uint8_t byte = (x / 32 + y / 32) % 2 == 0 ? 37 : 225;
        return Color{byte, byte, byte, 255};
    };
    const double dark = static_cast<double>(linear_of_srgb(37)), light = static_cast<double>(linear_of_srgb(225));
    for (const bool nearest : {true, false}) {
        const Board board(texture_of(512, 512, checks, nearest));
        const double mean_albedo = texture_mean(board.scene.textures[0]).x;
        EXPECT_NEAR(mean_albedo, 0.5 * (dark + light), 1e-6);
        for (const int side : {400, 300}) {
            const Image image = picture_of(board, facing_camera(), side, Picture::full_draws);
            const std::vector<float>& red = image.channel(stokes_channel(0, 0));
            double sum = 0;
            int widest = 0;
            for (int row = 0; row < side; ++row) {
                int mixed = 0;
                for (int column = 0; column < side; ++column) {
                    const double value = static_cast<double>(red[static_cast<std::size_t>(row * side + column)]);
                    sum += value;
                    const double share = (value - dark) / (light - dark);
                    mixed = share > 0.02 && share < 0.98 ? mixed + 1 : 0;
                    const double check_row = std::fmod((row + 0.5) / side * 16, 1.0);
                    if (std::abs(check_row - 0.5) < 0.3) widest = std::max(widest, mixed);  // no edge along the row
                }
            }
            std::printf("side %d %s: widest edge %d pixels, mean %.6f of %.6f (%+.4f %%)\n", side,
                        nearest ? "nearest" : "linear", widest, sum / (side * side), mean_albedo,
                        100 * (sum / (side * side) / mean_albedo - 1));
            EXPECT_LE(widest, nearest ? 1 : 2);
            EXPECT_NEAR(sum / (side * side), mean_albedo, 1e-3 * mean_albedo);
        }
    }
}

// The picture's texture is the photons': GL against albedo_at, pixel by pixel, along a slanted look at a board whose
// coordinates run over several wrapped copies.
TEST_F(AlbedoTexturesTest, PicturesAndPhotonsSeeTheSameTexture) {
    const auto hills = [](int x, int y) {
        return Color{static_cast<std::uint8_t>(20 * x), static_cast<std::uint8_t>(255 - 30 * y),
                     static_cast<std::uint8_t>(x * y), 255};
    };
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
        Board board(texture_of(12, 8, hills, false));
        board.scene.textures[0].wrap_u = wrap;
        board.scene.textures[0].wrap_v = Wrap::mirror;
        for (glm::vec2& place : board.scene.texture_coordinates) place = 3.0f * place - 0.7f;
        board.scene.vertex_colors = {{1, 1, 1, 1}, {0.5f, 1, 1, 1}, {1, 0.25f, 1, 1}, {1, 1, 0, 1},
                                     {1, 1, 1, 1}, {1, 1, 1, 1},    {1, 1, 1, 1},     {1, 1, 1, 1}};
        Camera camera = facing_camera();
        camera.position = {1.2f, 0.4f, 2.0f};
        camera.forward = glm::normalize(glm::vec3(-1.0f, -0.3f, -2.0f));
        camera.up = glm::normalize(glm::vec3(0, 1, 0) - camera.forward.y * camera.forward);
        constexpr int side = 64;
        const Image image = picture_of(board, camera, side, 1);
        const Rays rays(board.scene);
        int compared = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                constexpr float first_draw = 0.5f - 1.0f / 128;
                Ray ray;
                ray.origin = camera.position;
                ray.direction = ray_direction(camera, side, side, static_cast<float>(x) + first_draw,
                                              static_cast<float>(y) + first_draw);
                Hit hit;
                rays.intersect({&ray, 1}, {&hit, 1});
                if (hit.escaped() || hit.b1 < 0.01f || hit.b2 < 0.01f || hit.b1 + hit.b2 > 0.99f) continue;
                ++compared;
                const glm::vec3 albedo = albedo_at(board.scene, hit) * glm::vec3(1.0f, 0.5f, 0.25f);
                for (int band = 0; band < 3; ++band) {
                    const float seen = image.channel(stokes_channel(0, band))[static_cast<std::size_t>(y * side + x)];
                    // Drivers may interpolate with 8 bits between texels: up to 1/256 of a step of one half.
                    ASSERT_NEAR(seen, albedo[band], 2.5e-3) << x << " " << y << " band " << band;
                }
            }
        EXPECT_GT(compared, side * side / 2);
    }
}

TEST_F(AlbedoTexturesTest, OneLooksThroughHoles) {
    const auto halves = [](int x, int) { return Color{255, 255, 255, static_cast<std::uint8_t>(x == 0 ? 127 : 128)}; };
    const Board board(texture_of(2, 1, halves, true), 0.5f);
    const Image image = picture_of(board, facing_camera(), 32, 4);
    const std::vector<float>& red = image.channel(stokes_channel(0, 0));
    for (int row = 0; row < 32; ++row) {
        EXPECT_NEAR(red[static_cast<std::size_t>(32 * row + 4)], 0.25f, 1e-5);  // the wall
        EXPECT_NEAR(red[static_cast<std::size_t>(32 * row + 28)], 1.0f, 1e-5);
    }
}

// Nothing enters a metal, so nothing comes back from under its surface, whatever colours it.
TEST_F(AlbedoTexturesTest, OnlyBasesAreColoured) {
    const auto green = [](int, int) { return Color{0, 255, 0, 255}; };
    Board board(texture_of(1, 1, green, true), 0.5f);
    Material& metal = board.scene.materials[0];
    metal.base = Base::black;
    metal.interface.kind = InterfaceKind::conductor;
    metal.interface.n = glm::vec3(1.0f);
    metal.interface.k = glm::vec3(2.0f);
    const Image image = picture_of(board, facing_camera(), 8, 1);
    for (int band = 0; band < 3; ++band) EXPECT_EQ(image.channel(stokes_channel(0, band))[20], 0.0f);
}

}  // namespace
}  // namespace brewster
