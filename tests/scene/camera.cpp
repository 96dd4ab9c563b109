#include "scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace brewster {
namespace {

Camera oblique() {
    Camera camera;
    camera.position = {1, 2, 3};
    camera.forward = glm::normalize(glm::vec3(-1, -0.5f, -2));
    camera.up = glm::normalize(glm::cross(glm::cross(camera.forward, glm::vec3(0, 1, 0)), camera.forward));
    camera.vertical_field_of_view = 0.9f;
    return camera;
}

TEST(Camera, AxesAreRightHanded) {
    const Camera camera;
    EXPECT_EQ(camera.right(), glm::vec3(1, 0, 0));
}

TEST(Camera, MiddleRayLooksForward) {
    const Camera camera = oblique();
    EXPECT_NEAR(glm::distance(ray_direction(camera, 640, 480, 320, 240), camera.forward), 0, 1e-6);
}

TEST(Camera, FieldOfViewIsThatOfTheHeight) {
    const Camera camera = oblique();
    const glm::vec3 top = ray_direction(camera, 640, 480, 320, 0), bottom = ray_direction(camera, 640, 480, 320, 480);
    EXPECT_NEAR(std::acos(glm::dot(top, bottom)), 0.9, 1e-5);
    EXPECT_GT(glm::dot(top, camera.up), 0);  // row 0 on top
    const glm::vec3 left = ray_direction(camera, 640, 480, 0, 240);
    EXPECT_LT(glm::dot(left, camera.right()), 0);
    EXPECT_NEAR(-glm::dot(left, camera.right()) / glm::dot(left, camera.forward), std::tan(0.45) * 640 / 480, 1e-5);
}

// What a ray through pixel (x, y) meets is drawn at that pixel, less the jitter; both functions say one camera.
TEST(Camera, ProjectionAndRaysAgree) {
    const Camera camera = oblique();
    constexpr int width = 320, height = 200;
    for (const float jitter_x : {-0.5f, 0.0f, 0.25f})
        for (const float jitter_y : {0.0f, 0.375f})
            for (const float x : {0.5f, 100.5f, 319.5f})
                for (const float y : {0.5f, 77.5f, 199.5f}) {
                    const glm::vec3 p =
                        camera.position + 7.0f * ray_direction(camera, width, height, x - jitter_x, y - jitter_y);
                    const glm::vec4 clip =
                        view_projection(camera, width, height, jitter_x, jitter_y, 100) * glm::vec4(p, 1);
                    EXPECT_NEAR((clip.x / clip.w + 1) / 2 * width, x, 1e-3);
                    EXPECT_NEAR((1 - clip.y / clip.w) / 2 * height, y, 1e-3);
                    EXPECT_GT(clip.w, 0);
                }
}

TEST(Camera, DepthRunsFromNearToFar) {
    Camera camera = oblique();
    camera.near_distance = 0.5f;
    const glm::mat4 m = view_projection(camera, 100, 100, 0, 0, 20);
    const auto depth = [&](float distance) {
        const glm::vec4 clip = m * glm::vec4(camera.position + distance * camera.forward, 1);
        return clip.z / clip.w;
    };
    EXPECT_NEAR(depth(0.5f), -1, 1e-5);
    EXPECT_NEAR(depth(20), 1, 1e-5);
}

}  // namespace
}  // namespace brewster
