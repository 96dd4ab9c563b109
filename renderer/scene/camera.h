#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace brewster {

/// A pinhole camera in scene coordinates (recentred, metres).
struct Camera {
    std::string name;       ///< of its node, made unique
    std::string file_name;  ///< its own name in the file
    glm::vec3 position{0.0f};
    glm::vec3 forward{0.0f, 0.0f, -1.0f};  ///< unit
    glm::vec3 up{0.0f, 1.0f, 0.0f};        ///< unit, orthogonal to forward
    float vertical_field_of_view = 0.8f;   ///< radians, the full angle of the picture's height
    float aspect_ratio = 4.0f / 3.0f;      ///< width over height that the file wishes for; a picture may have another
    float near_distance = 0.01f;           ///< metres

    glm::vec3 right() const;  ///< cross(forward, up)
};

/// The same pictures of any one size, whatever the camera is called.
inline bool same_pose(const Camera& a, const Camera& b) {
    return a.position == b.position && a.forward == b.forward && a.up == b.up &&
           a.vertical_field_of_view == b.vertical_field_of_view;
}

/// GL clip coordinates for a picture of this shape; `jitter` moves it right and down by a fraction of a pixel, each in
/// [-0.5, 0.5]: the middle of pixel (i, j) then shows what ray_direction sees at (i + 0.5 - jitter_x, j + 0.5 -
/// jitter_y). `far_distance` is measured from the camera and must hold the scene.
glm::mat4 view_projection(const Camera& camera, int width, int height, float jitter_x, float jitter_y,
                          float far_distance);

/// Unit directions through points of a picture in pixels, row 0 on top.
class PictureRays {
  public:
    PictureRays(const Camera& camera, int width, int height);
    glm::vec3 direction(float x, float y) const;

  private:
    glm::dvec3 forward_, right_, up_;
    double width_, height_, half_;
};

/// One of them.
glm::vec3 ray_direction(const Camera& camera, int width, int height, float x, float y);

}  // namespace brewster
