#pragma once
#include <glm/vec2.hpp>

namespace brewster {

enum class Key { n, p, q, home, other };
enum class Button { left, middle, right };

/// One thing a person did, in the order it was done. Places are in pixels of the framebuffer from the upper left.
struct InputEvent {
    enum class Kind { key_press, button_press, button_release, motion, wheel };
    Kind kind = Kind::motion;
    Key key = Key::other;
    Button button = Button::left;
    bool shift = false, control = false;
    glm::vec2 place{0.0f};  ///< of the pointer
    float notches = 0;      ///< of the wheel, forward positive
};

}  // namespace brewster
