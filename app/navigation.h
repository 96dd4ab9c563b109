#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <optional>

#include "app/input.h"
#include "scene/camera.h"

namespace brewster {

/// Turns the camera around `pivot`, which keeps its place in the picture: by `yaw` about the vertical (y) axis, then by
/// `pitch` about its own right, both in radians. It never looks closer than a degree to straight up or down.
Camera orbited(const Camera& camera, glm::vec3 pivot, float yaw, float pitch);

/// Moves the camera in its picture plane so that what lies at `depth` metres along its forward axis moves by `pixels`
/// (right, down) in a picture of this height.
Camera panned(const Camera& camera, float depth, glm::vec2 pixels, int picture_height);

/// Moves the camera towards `point`, whose distance is multiplied by `factor`; the direction of view stays, and so does
/// the point's place in the picture.
Camera dollied(const Camera& camera, glm::vec3 point, float factor);

/// Moves along right, up and forward (each -1, 0 or 1), so many metres.
Camera flown(const Camera& camera, glm::vec3 way, float metres);

/// Backs off or comes near along its own line of sight until a sphere just fits, and stands in the middle.
Camera framed(const Camera& camera, glm::vec3 centre, float radius);

/// Looks at the origin along `forward` (unit) from where a sphere around it just fits.
Camera looking_along(const Camera& camera, glm::vec3 forward, float radius);

/// Answers what the camera sees at a pixel: a point of the scene, or nothing.
using Seen = std::function<std::optional<glm::vec3>(const Camera&, glm::vec2 place)>;

/// Mouse to camera. Left drag: orbit around what stands in the middle of the picture, or around the pivot where one was
/// set; middle drag, or left with Shift: pan, the point under the pointer stays under it; right drag: turn where one
/// stands; wheel: dolly to the point under the pointer.
class Navigation {
  public:
    /// `radius` of the scene in metres stands for the distance where nothing is seen.
    Navigation(Seen seen, float radius) : seen_(std::move(seen)), radius_(radius) {}

    /// The camera after the event, in a picture of this size.
    Camera moved(const Camera& camera, const InputEvent& event, glm::ivec2 picture_size);
    bool dragging() const { return drag_ != Drag::none; }
    bool flying() const { return drag_ == Drag::look; }
    /// What to orbit around from now on; none: what stands in the middle of the picture.
    void set_pivot(std::optional<glm::vec3> pivot) { pivot_ = pivot; }
    /// Forgets a drag that has begun: another camera was chosen, or the window lost the pointer.
    void release() { drag_ = Drag::none; }

  private:
    enum class Drag { none, orbit, pan, look };

    glm::vec3 target(const Camera& camera, glm::vec2 place, glm::ivec2 picture_size) const;

    Seen seen_;
    float radius_;
    std::optional<glm::vec3> pivot_;
    Drag drag_ = Drag::none;
    Button button_ = Button::left;
    glm::vec2 place_{0.0f};
    glm::vec3 anchor_{0.0f};  ///< pivot, or the point that follows the pointer
};

}  // namespace brewster
