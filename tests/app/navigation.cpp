#include "app/navigation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace brewster {
namespace {

constexpr float pi_f = std::numbers::pi_v<float>;
constexpr glm::ivec2 size(800, 600);

Camera camera_at(glm::vec3 position, glm::vec3 forward) {
    Camera camera;
    camera.position = position;
    camera.forward = glm::normalize(forward);
    camera.up = glm::normalize(glm::cross(glm::cross(camera.forward, {0, 1, 0}), camera.forward));
    return camera;
}

/// Where a point of the scene lies in the picture, in pixels.
glm::vec2 place_of(const Camera& camera, glm::vec3 point) {
    const glm::vec4 clip = view_projection(camera, size.x, size.y, 0, 0, 100) * glm::vec4(point, 1);
    return {(clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(size.x),
            (0.5f - clip.y / clip.w * 0.5f) * static_cast<float>(size.y)};
}

void expect_near(glm::vec3 a, glm::vec3 b, float tolerance) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

void expect_frame(const Camera& camera) {
    EXPECT_NEAR(glm::length(camera.forward), 1, 1e-5f);
    EXPECT_NEAR(glm::length(camera.up), 1, 1e-5f);
    EXPECT_NEAR(glm::dot(camera.forward, camera.up), 0, 1e-5f);
}

InputEvent event(InputEvent::Kind kind, glm::vec2 place, Button button = Button::left, bool shift = false) {
    InputEvent result;
    result.kind = kind;
    result.place = place;
    result.button = button;
    result.shift = shift;
    return result;
}

TEST(Orbited, GoesRoundThePivot) {
    const Camera before = camera_at({0, 0, 2}, {0, 0, -1});
    const Camera left = orbited(before, {0, 0, 0}, -pi_f / 2, 0);  // a quarter to the left: the pivot turns right
    expect_near(left.position, {-2, 0, 0}, 1e-5f);
    expect_near(left.forward, {1, 0, 0}, 1e-5f);
    const Camera above = orbited(before, {0, 0, 0}, 0, -pi_f / 4);
    expect_near(above.position, {0, std::sqrt(2.0f), std::sqrt(2.0f)}, 1e-5f);
}

TEST(Orbited, PivotKeepsItsPlaceAndHorizonsStayLevel) {
    const Camera before = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    const glm::vec3 pivot(0.2f, -0.1f, 0.4f);
    for (const float yaw : {-2.0f, 0.1f, 1.3f}) {
        for (const float pitch : {-0.4f, 0.0f, 0.7f}) {
            const Camera after = orbited(before, pivot, yaw, pitch);
            expect_frame(after);
            EXPECT_LT(glm::length(place_of(after, pivot) - place_of(before, pivot)), 0.05f);
            EXPECT_NEAR(after.right().y, 0, 1e-5f);
        }
    }
}

TEST(Orbited, StopsBeforeTheVertical) {
    Camera camera = camera_at({0, 0, 2}, {0, 0, -1});
    for (int i = 0; i < 50; ++i) camera = orbited(camera, {0, 0, 0}, 0.3f, -0.2f);
    EXPECT_LT(camera.forward.y, -0.999f);
    EXPECT_GT(camera.up.x * camera.up.x + camera.up.z * camera.up.z, 0.99f);
    expect_frame(camera);
    for (int i = 0; i < 100; ++i) camera = orbited(camera, {0, 0, 0}, -0.1f, 0.2f);
    EXPECT_GT(camera.forward.y, 0.999f);
    expect_frame(camera);
}

TEST(Panned, GrabbedPointFollows) {
    const Camera before = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    const glm::vec3 point(0.2f, -0.1f, 0.4f);
    const float depth = glm::dot(point - before.position, before.forward);
    const Camera after = panned(before, depth, {30, -20}, size.y);
    const glm::vec2 step = place_of(after, point) - place_of(before, point);
    EXPECT_NEAR(step.x, 30, 0.01f);
    EXPECT_NEAR(step.y, -20, 0.01f);
    EXPECT_EQ(after.forward, before.forward);
}

TEST(Dollied, PointStaysInPlaceAndComesNearer) {
    const Camera before = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    const glm::vec3 point(0.2f, -0.1f, 0.4f);
    const Camera after = dollied(before, point, 0.5f);
    EXPECT_NEAR(glm::length(after.position - point), 0.5f * glm::length(before.position - point), 1e-5f);
    EXPECT_LT(glm::length(place_of(after, point) - place_of(before, point)), 0.01f);
    Camera camera = before;
    for (int i = 0; i < 100; ++i) camera = dollied(camera, point, 0.5f);
    EXPECT_GE(glm::length(camera.position - point), 1.99f * camera.near_distance);
    expect_near(dollied(dollied(before, point, 0.5f), point, 2.0f).position, before.position, 1e-5f);
}

class NavigationTest : public testing::Test {
  protected:
    const glm::vec3 point_{0.2f, -0.1f, 0.4f};
    Camera camera_ = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    Navigation navigation_{[this](const Camera&, glm::vec2) { return std::optional(point_); }, 2.0f};
};

TEST_F(NavigationTest, LeftDragOrbits) {
    const Camera before = camera_;
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}), size);
    EXPECT_TRUE(navigation_.dragging());
    EXPECT_EQ(camera_.position, before.position);
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::motion, {150, 100}), size);
    expect_near(camera_.position, orbited(before, point_, -pi_f * 50 / 600, 0).position, 1e-5f);
    EXPECT_NEAR(glm::length(camera_.position - point_), glm::length(before.position - point_), 1e-5f);
    navigation_.moved(camera_, event(InputEvent::Kind::button_release, {150, 100}), size);
    EXPECT_FALSE(navigation_.dragging());
    const Camera rest = navigation_.moved(camera_, event(InputEvent::Kind::motion, {300, 300}), size);
    EXPECT_EQ(rest.position, camera_.position);
}

TEST_F(NavigationTest, MiddleAndShiftLeftPan) {
    for (const auto& [button, shift] : {std::pair{Button::middle, false}, {Button::left, true}}) {
        Camera camera = camera_;
        camera = navigation_.moved(camera, event(InputEvent::Kind::button_press, {100, 100}, button, shift), size);
        camera = navigation_.moved(camera, event(InputEvent::Kind::motion, {140, 90}), size);
        navigation_.moved(camera, event(InputEvent::Kind::button_release, {140, 90}, button), size);
        const glm::vec2 step = place_of(camera, point_) - place_of(camera_, point_);
        EXPECT_NEAR(step.x, 40, 0.01f);
        EXPECT_NEAR(step.y, -10, 0.01f);
    }
}

TEST_F(NavigationTest, WheelComesNearerAndGoesBack) {
    InputEvent wheel = event(InputEvent::Kind::wheel, {10, 10});
    wheel.notches = 2;
    const Camera near = navigation_.moved(camera_, wheel, size);
    EXPECT_NEAR(glm::length(near.position - point_), 0.85f * 0.85f * glm::length(camera_.position - point_), 1e-5f);
    wheel.notches = -2;
    expect_near(navigation_.moved(near, wheel, size).position, camera_.position, 1e-5f);
}

TEST_F(NavigationTest, OtherButtonsDoNotDisturbADrag) {
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}), size);
    navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}, Button::middle), size);
    navigation_.moved(camera_, event(InputEvent::Kind::button_release, {100, 100}, Button::middle), size);
    EXPECT_TRUE(navigation_.dragging());
    navigation_.release();
    EXPECT_FALSE(navigation_.dragging());
}

TEST_F(NavigationTest, RightDragTurnsWhereOneStands) {
    const Camera before = camera_;
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}, Button::right), size);
    EXPECT_TRUE(navigation_.flying());
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::motion, {160, 90}), size);
    expect_near(camera_.position, before.position, 1e-5f);
    EXPECT_GT(glm::length(camera_.forward - before.forward), 0.1f);
    navigation_.moved(camera_, event(InputEvent::Kind::button_release, {160, 90}, Button::right), size);
    EXPECT_FALSE(navigation_.flying());
}

TEST_F(NavigationTest, APivotIsTurnedAround) {
    const glm::vec3 pivot(1, 0, 0);
    navigation_.set_pivot(pivot);
    const Camera before = camera_;
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}), size);
    camera_ = navigation_.moved(camera_, event(InputEvent::Kind::motion, {190, 120}), size);
    EXPECT_NEAR(glm::length(camera_.position - pivot), glm::length(before.position - pivot), 1e-5f);
}

TEST(Flown, GoesWhereOneLooks) {
    const Camera before = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    expect_near(flown(before, {0, 0, 1}, 2).position, before.position + 2.0f * before.forward, 1e-6f);
    expect_near(flown(before, {-1, 0, 0}, 1).position, before.position - before.right(), 1e-6f);
}

TEST(Framed, TheSphereJustFits) {
    const Camera before = camera_at({1, 0.5f, 2}, {-0.2f, -0.3f, -1});
    const glm::vec3 centre(0.3f, -0.2f, 0.1f);
    const Camera after = framed(before, centre, 0.5f);
    EXPECT_LT(glm::length(place_of(after, centre) - 0.5f * glm::vec2(size)), 0.05f);
    // A point of the sphere's outline as the camera sees it: on the tangent, half the field of view from the middle.
    const float half = 0.5f * before.vertical_field_of_view;
    const glm::vec3 tangent = centre + 0.5f * (std::cos(half) * after.up - std::sin(half) * after.forward);
    EXPECT_NEAR(place_of(after, tangent).y, 0, 0.1f);
    expect_frame(looking_along(before, {0, -1, 0}, 1));
    expect_frame(looking_along(before, {1, 0, 0}, 1));
}

TEST_F(NavigationTest, ReleasedDragsAreForgotten) {
    navigation_.moved(camera_, event(InputEvent::Kind::button_press, {100, 100}), size);
    navigation_.release();
    EXPECT_EQ(navigation_.moved(camera_, event(InputEvent::Kind::motion, {300, 300}), size).position, camera_.position);
}

TEST(Navigation, WhereNothingIsSeenTheWheelStillMoves) {
    Navigation navigation([](const Camera&, glm::vec2) { return std::optional<glm::vec3>(); }, 2.0f);
    const Camera before = camera_at({0, 0, 5}, {0, 0, -1});
    InputEvent wheel = event(InputEvent::Kind::wheel, {400, 300});
    wheel.notches = 1;
    const Camera after = navigation.moved(before, wheel, size);
    expect_near(after.position, {0, 0, 5 * 0.85f}, 1e-4f);
}

}  // namespace
}  // namespace brewster
