#include "app/seen_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace brewster {
namespace {

// The box is open at the front and its walls absorb on their backs: from behind one sees through the back wall.
TEST(SeenPoint, LooksThroughAbsorbingBacks) {
    const Scene scene = read_scene(BREWSTER_SOURCE_DIR "/assets/scenes/cornell-box.gltf");
    const Rays rays(scene);
    const glm::vec3 middle(0.5f * (scene.low + scene.high));
    for (const Camera& camera : scene.cameras) {
        EXPECT_TRUE(seen_point(rays, camera.position, camera.forward)) << camera.name;
    }
    const glm::vec3 above(middle.x + 0.02f, scene.high.y + 1, middle.z + 0.3f);
    const std::optional<glm::vec3> floor = seen_point(rays, above, {0, -1, 0});
    ASSERT_TRUE(floor);
    EXPECT_LT(floor->y, scene.high.y - 0.1f);
    EXPECT_FALSE(seen_point(rays, above, {0, 1, 0}));
}

}  // namespace
}  // namespace brewster
