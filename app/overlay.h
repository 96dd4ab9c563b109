#pragma once
#include "app/input.h"
#include "app/window.h"

namespace brewster {

/// Widgets over the picture: Dear ImGui in a window. Made after the window, gone before it.
class Overlay {
  public:
    explicit Overlay(Window& window);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Height of the text, `scale` times that of the desktop (0.8 to 2), and light or dark. Cheap when nothing changes.
    void set_style(float scale, bool light);
    float text_scale() const { return built_scale_; }  ///< pixels a panel of text scale 1 and content scale 1 has each

    /// Widgets may be made between these two.
    void begin();
    void end();
    void draw();  ///< onto the window, over what is there

    /// As a person's event would reach widgets; the real mouse no longer does.
    void script(const InputEvent& event);
    void script_text(const std::string& text);

    bool wants_mouse() const;    ///< the pointer is over a widget, or a widget holds it
    bool wants_text() const;     ///< a text field is being written in
    bool is_being_used() const;  ///< a widget is held
    void release_keyboard();     ///< the picture was clicked

  private:
    void build_font();

    Window& window_;
    float built_scale_ = 0;
    bool light_ = false;
    bool scripted_ = false;
    glm::vec2 pointer_{0.0f};
    bool buttons_[3] = {};
    std::string released_key_;
};

}  // namespace brewster
