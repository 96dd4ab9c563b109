#pragma once
#include <glm/vec2.hpp>
#include <string>

namespace brewster {

enum class Button { left, middle, right };

/// One thing a person did, in the order it was done. Places are in pixels of the framebuffer from the upper left.
struct InputEvent {
    enum class Kind { key_press, key_release, button_press, button_release, motion, wheel };
    Kind kind = Kind::motion;
    std::string key;  ///< as the key table writes it: "P", ",", "F1", "Home", "Keypad 1"; letters by the layout
    Button button = Button::left;
    bool shift = false, control = false, alt = false;
    bool repeat = false;    ///< a press that the keyboard says again, since the key is held
    glm::vec2 place{0.0f};  ///< of the pointer
    float notches = 0;      ///< of the wheel, forward positive
};

}  // namespace brewster
