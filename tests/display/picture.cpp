#include "display/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bins/lookup.h"
#include "display/osmesa_context.h"
#include "display/tone.h"
#include "hand_made.h"

namespace brewster {
namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

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

TEST(Picture, RadianceIsEmissionAndReflectedIrradiance) {
    const OsmesaContext context;
    const Room room;
    auto bins = std::make_shared<Snapshot>(hand_made::empty_bins(room.scene));
    bins->nodes[bins->charts[room.floor].direct_root] = hand_made::add_leaf(*bins, {1, 3, 2, 4}, 0, 0.3f);
    bins->nodes[bins->charts[room.floor].indirect_root] = hand_made::add_leaf(*bins, {2, 2, 2, 2}, 0, 0.4f);
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
            const float u = (static_cast<float>(x) + 0.5f) / 64, v = 1 - (static_cast<float>(y) + 0.5f) / 64;
            const float irradiance = 1 + 2 * u + v + 2;
            const auto pixel = static_cast<std::size_t>(64 * y + x);
            for (int band = 0; band < 3; ++band) {
                const float factor = band == 0 ? 1.0f : band == 1 ? 0.5f : 0.25f;
                const float expected = albedo[band] / pi_f * irradiance * factor;
                EXPECT_NEAR(image.channel(stokes_channel(0, band))[pixel], expected, 2e-6f * expected);
                const float error = albedo[band] / pi_f * 0.5f * factor;
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

}  // namespace
}  // namespace brewster
