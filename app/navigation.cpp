#include "app/navigation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace brewster {
namespace {

constexpr float closest_to_vertical = std::numbers::pi_v<float> / 180;
constexpr float factor_per_notch = 0.85f;
constexpr glm::vec3 vertical(0.0f, 1.0f, 0.0f);

Camera turned(const Camera& camera, glm::vec3 pivot, const glm::quat& rotation) {
    Camera result = camera;
    result.position = pivot + rotation * (camera.position - pivot);
    result.forward = glm::normalize(rotation * camera.forward);
    result.up = glm::normalize(rotation * camera.up);
    result.up = glm::normalize(result.up - glm::dot(result.up, result.forward) * result.forward);
    return result;
}

float angle_to_vertical(const Camera& camera) {
    return std::acos(std::clamp(glm::dot(camera.forward, vertical), -1.0f, 1.0f));
}

}  // namespace

Camera orbited(const Camera& camera, glm::vec3 pivot, float yaw, float pitch) {
    // Pitching about an axis that is level changes the angle to the vertical by just as much.
    const glm::vec3 across = glm::cross(camera.forward, vertical);
    const glm::vec3 level = glm::length(across) > 1e-4f ? glm::normalize(across) : camera.right();
    const float angle = angle_to_vertical(camera);
    const float least = std::min(closest_to_vertical, angle);
    const float most = std::max(std::numbers::pi_v<float> - closest_to_vertical, angle);
    const float allowed = angle - std::clamp(angle - pitch, least, most);
    const Camera pitched = turned(camera, pivot, glm::angleAxis(allowed, level));
    return turned(pitched, pivot, glm::angleAxis(yaw, vertical));
}

Camera panned(const Camera& camera, float depth, glm::vec2 pixels, int picture_height) {
    const float metres =
        2 * depth * std::tan(0.5f * camera.vertical_field_of_view) / static_cast<float>(picture_height);
    Camera result = camera;
    result.position += metres * (pixels.y * camera.up - pixels.x * camera.right());
    return result;
}

Camera dollied(const Camera& camera, glm::vec3 point, float factor) {
    Camera result = camera;
    const glm::vec3 away = camera.position - point;
    // The point must stay outside of the near plane, or one falls through what one looks at.
    const float least = 2 * camera.near_distance / std::max(glm::length(away), 1e-9f);
    result.position = point + away * (factor < 1 ? std::min(1.0f, std::max(factor, least)) : factor);
    return result;
}

Camera flown(const Camera& camera, glm::vec3 way, float metres) {
    Camera result = camera;
    result.position += metres * (way.x * camera.right() + way.y * camera.up + way.z * camera.forward);
    return result;
}

Camera framed(const Camera& camera, glm::vec3 centre, float radius) {
    Camera result = camera;
    const float distance = std::max(radius, 1e-6f) / std::sin(0.5f * camera.vertical_field_of_view);
    result.position = centre - distance * camera.forward;
    return result;
}

Camera looking_along(const Camera& camera, glm::vec3 forward, float radius) {
    Camera result = camera;
    result.forward = forward;
    result.up = std::abs(forward.y) > 0.999f ? glm::vec3(0, 0, -1) : vertical;
    return framed(result, glm::vec3(0.0f), radius);
}

glm::vec3 Navigation::target(const Camera& camera, glm::vec2 place, glm::ivec2 picture_size) const {
    if (const std::optional<glm::vec3> point = seen_(camera, place)) return *point;
    const glm::vec3 ray = ray_direction(camera, picture_size.x, picture_size.y, place.x, place.y);
    return camera.position + ray * std::max(glm::length(camera.position), 0.1f * radius_);
}

Camera Navigation::moved(const Camera& camera, const InputEvent& event, glm::ivec2 picture_size) {
    switch (event.kind) {
        case InputEvent::Kind::button_press:
            if (dragging()) return camera;
            drag_ = event.button == Button::right                   ? Drag::look
                    : event.button == Button::middle || event.shift ? Drag::pan
                                                                    : Drag::orbit;
            button_ = event.button;
            place_ = event.place;
            anchor_ = drag_ == Drag::look ? camera.position
                      : drag_ == Drag::orbit && pivot_
                          ? *pivot_
                          : target(camera, drag_ == Drag::pan ? place_ : 0.5f * glm::vec2(picture_size), picture_size);
            return camera;
        case InputEvent::Kind::button_release:
            if (event.button == button_) release();
            return camera;
        case InputEvent::Kind::motion: {
            if (!dragging()) return camera;
            const glm::vec2 step = event.place - place_;
            place_ = event.place;
            if (drag_ == Drag::pan) {
                const float depth = glm::dot(anchor_ - camera.position, camera.forward);
                return panned(camera, std::max(depth, camera.near_distance), step, picture_size.y);
            }
            // The height of the picture is half a turn.
            const glm::vec2 angle = std::numbers::pi_v<float> / static_cast<float>(picture_size.y) * step;
            if (drag_ == Drag::look) return orbited(camera, camera.position, -angle.x, -angle.y);
            return orbited(camera, anchor_, -angle.x, -angle.y);
        }
        case InputEvent::Kind::wheel:
            return dollied(camera, target(camera, event.place, picture_size),
                           std::pow(factor_per_notch, event.notches));
        case InputEvent::Kind::key_press:
        case InputEvent::Kind::key_release:
            break;
    }
    return camera;
}

}  // namespace brewster
