#pragma once
#include <vector>

#include "display/gl_object.h"

namespace brewster {

/// Some RGBA32F textures of one size to draw into, with or without depth.
class RenderTarget {
  public:
    RenderTarget() = default;
    /// Throws Error when the driver cannot hold pictures of this size.
    RenderTarget(int width, int height, int textures, bool depth);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes it what is drawn into, all of it.
    void bind() const;
    void clear() const;  ///< to zero, and to the farthest depth; it must be bound
    GLuint texture(int index) const { return textures_[static_cast<std::size_t>(index)].id(); }
    /// Four floats a pixel, row 0 on top.
    std::vector<float> read(int index) const;

  private:
    int width_ = 0, height_ = 0;
    Framebuffer framebuffer_;
    std::vector<Texture> textures_;
    Renderbuffer depth_;
};

}  // namespace brewster
