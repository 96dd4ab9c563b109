#include "scene/camera.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace brewster {

glm::vec3 Camera::right() const {
    return glm::cross(forward, up);
}

glm::mat4 view_projection(const Camera& camera, int width, int height, float jitter_x, float jitter_y,
                          float far_distance) {
    const double half = std::tan(0.5 * static_cast<double>(camera.vertical_field_of_view));
    const double aspect = static_cast<double>(width) / static_cast<double>(height);
    const double near = static_cast<double>(camera.near_distance), far = static_cast<double>(far_distance);
    const glm::dvec3 x(camera.right()), y(camera.up), z(-camera.forward), position(camera.position);

    // glm holds columns.
    glm::dmat4 view(1.0);
    for (int k = 0; k < 3; ++k) {
        view[k][0] = x[k];
        view[k][1] = y[k];
        view[k][2] = z[k];
    }
    view[3] = glm::dvec4(-glm::dot(x, position), -glm::dot(y, position), -glm::dot(z, position), 1.0);

    glm::dmat4 projection(0.0);
    projection[0][0] = 1.0 / (half * aspect);
    projection[1][1] = 1.0 / half;
    projection[2][2] = (far + near) / (near - far);
    projection[2][3] = -1.0;
    projection[3][2] = 2.0 * far * near / (near - far);
    // A pixel is 2/width wide in clip coordinates; clip w is -z in the view, clip y points up.
    projection[2][0] = -2.0 * static_cast<double>(jitter_x) / width;
    projection[2][1] = 2.0 * static_cast<double>(jitter_y) / height;
    return glm::mat4(projection * view);
}

PictureRays::PictureRays(const Camera& camera, int width, int height)
    : forward_(camera.forward),
      right_(camera.right()),
      up_(camera.up),
      width_(width),
      height_(height),
      half_(std::tan(0.5 * static_cast<double>(camera.vertical_field_of_view))) {}

glm::vec3 PictureRays::direction(float x, float y) const {
    const double right = (2 * static_cast<double>(x) / width_ - 1) * half_ * (width_ / height_);
    const double up = (1 - 2 * static_cast<double>(y) / height_) * half_;
    return glm::vec3(glm::normalize(forward_ + right * right_ + up * up_));
}

glm::vec3 ray_direction(const Camera& camera, int width, int height, float x, float y) {
    return PictureRays(camera, width, height).direction(x, y);
}

}  // namespace brewster
