#include "app/ground_truth.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace brewster {
namespace {

class GroundTruth : public testing::Test {
  protected:
    GroundTruth() : scene_(read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf")), picture_(48, 32) {
        for (int component = 0; component < 4; ++component) {
            for (int band = 0; band < 3; ++band) {
                std::vector<float>& pixels = picture_.add_channel(stokes_channel(component, band));
                for (std::size_t i = 0; i < pixels.size(); ++i)
                    pixels[i] = component == 0 ? 2.0f : component == 1 ? 0.5f : component == 2 ? -1.0f : 0.25f;
            }
        }
        add_ground_truth(picture_, scene_, Rays(scene_), camera());
    }
    const Camera& camera() const { return scene_.camera("front"); }
    float at(const char* channel, std::size_t pixel) const { return picture_.channel(channel)[pixel]; }

    Scene scene_;
    Image picture_;
};

TEST_F(GroundTruth, PolarizersFollowMalus) {
    EXPECT_EQ(at("I0.R", 5), 1.25f);
    EXPECT_EQ(at("I45.G", 5), 0.5f);
    EXPECT_EQ(at("I90.B", 5), 0.75f);
    EXPECT_EQ(at("I135.R", 5), 1.5f);
}

// A position goes through the matrices of cameras.json back to the middle of its pixel, and its depth is the third
// coordinate. Hits are pulled inside by 1e-6 of their wall.
TEST_F(GroundTruth, MatricesProjectPositionsToTheirPixels) {
    const CameraMatrices matrices = camera_matrices(scene_, camera(), {picture_.width(), picture_.height()});
    int seen = 0;
    for (int y = 0; y < picture_.height(); ++y) {
        for (int x = 0; x < picture_.width(); ++x) {
            const auto i = static_cast<std::size_t>(picture_.width() * y + x);
            if (at("material", i) < 0) continue;
            ++seen;
            const double world[4] = {at("P.X", i), at("P.Y", i), at("P.Z", i), 1};
            double eye[3] = {};
            for (int row = 0; row < 3; ++row)
                for (int k = 0; k < 4; ++k) eye[row] += matrices.world_to_camera[row][k] * world[k];
            EXPECT_NEAR(eye[2], at("Z", i), 1e-5);
            EXPECT_NEAR(matrices.intrinsics[0][0] * eye[0] / eye[2] + matrices.intrinsics[0][2], x + 0.5, 1e-3);
            EXPECT_NEAR(matrices.intrinsics[1][1] * eye[1] / eye[2] + matrices.intrinsics[1][2], y + 0.5, 1e-3);
            const glm::vec3 normal(at("N.X", i), at("N.Y", i), at("N.Z", i));
            EXPECT_NEAR(glm::length(normal), 1, 1e-5);
            EXPECT_LT(glm::dot(normal, ray_direction(camera(), picture_.width(), picture_.height(),
                                                     static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)),
                      0)
                << "towards the camera";
        }
    }
    EXPECT_GT(seen, 48 * 32 / 2);
}

TEST_F(GroundTruth, MatricesAreInverseToEachOther) {
    const CameraMatrices m = camera_matrices(scene_, scene_.camera("low"), {64, 48});
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) sum += m.world_to_camera[row][k] * m.camera_to_world[k][column];
            EXPECT_NEAR(sum, row == column ? 1 : 0, 1e-6);
        }
    }
}

TEST_F(GroundTruth, MaterialsAreThoseOfTheWalls) {
    const auto middle_left = static_cast<std::size_t>(48 * 16 + 12), middle_right = middle_left + 23;
    const auto name = [&](std::size_t i) { return scene_.materials[static_cast<std::size_t>(at("material", i))].name; };
    EXPECT_EQ(name(middle_left), "red");
    EXPECT_EQ(name(middle_right), "green");
}

}  // namespace
}  // namespace brewster
