#pragma once
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "app/input.h"

struct GLFWwindow;

namespace brewster {

/// A window with an OpenGL 3.3 core context, current on the constructing thread, which alone may use it.
class Window {
  public:
    /// `size` in screen coordinates. Throws Error in GLFW's words where no window can be opened.
    Window(const std::string& title, glm::ivec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void poll_events();
    void wait_events(double seconds);  ///< until something happens, but no longer

    /// What was done since the last call.
    std::vector<InputEvent> take_events();
    /// True once after the contents were lost or the size changed.
    bool take_damage();
    bool close_requested() const;
    /// In pixels; 0 x 0 while it is minimised.
    glm::ivec2 framebuffer_size() const;
    void swap();

    /// Ends a wait, from any thread.
    static void wake();

  private:
    struct Callbacks;
    glm::vec2 pointer() const;

    GLFWwindow* window_ = nullptr;
    std::vector<InputEvent> events_;
    bool damaged_ = true;
};

}  // namespace brewster
