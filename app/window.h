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
    /// Files that were dropped on it.
    std::vector<std::string> take_drops();
    /// True once after the contents were lost or the size changed.
    bool take_damage();
    bool close_requested() const;
    bool hidden() const;  ///< minimised
    /// In pixels; 0 x 0 while it is minimised.
    glm::ivec2 framebuffer_size() const;
    float content_scale() const;  ///< of the desktop: 2 where text should be twice as large
    void swap();

    void set_title(const std::string& title);
    void toggle_full_screen();
    void resize(glm::ivec2 size);  ///< in screen coordinates
    void minimise(bool minimised);
    void hide();
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    /// Where the pointer is, in pixels from the upper left.
    glm::vec2 pointer() const { return pointer_; }
    /// As if a person had done it; from now on the pointer is where such events say.
    void script(const InputEvent& event);

    GLFWwindow* handle() const { return window_; }

    /// Ends a wait, from any thread.
    static void wake();

  private:
    struct Callbacks;

    GLFWwindow* window_ = nullptr;
    std::vector<InputEvent> events_;
    std::vector<std::string> drops_;
    bool damaged_ = true;
    glm::vec2 pointer_{-1.0f};                         ///< where the last event left it
    glm::ivec2 windowed_place_{0}, windowed_size_{0};  ///< before full screen
};

}  // namespace brewster
