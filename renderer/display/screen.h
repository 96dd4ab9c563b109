#pragma once
#include "display/gl_object.h"
#include "image/png.h"

namespace brewster {

/// Where pictures for the eye are drawn, in eight bits: the window, or a buffer of its own where there is none.
class Screen {
  public:
    static Screen window(int width, int height);      ///< size of the window's framebuffer in pixels
    static Screen off_screen(int width, int height);  ///< throws Error when the driver cannot hold it

    int width() const { return width_; }
    int height() const { return height_; }

    void bind() const;
    void clear() const;  ///< to black; it must be bound
    /// Until `unclip`, only columns from one share of the width to another are drawn to.
    void clip(float from, float to) const;
    void unclip() const;
    ScreenImage read() const;

  private:
    Screen(int width, int height) : width_(width), height_(height) {}

    int width_, height_;
    Framebuffer framebuffer_;  ///< empty: the window's
    Texture texture_;
};

}  // namespace brewster
