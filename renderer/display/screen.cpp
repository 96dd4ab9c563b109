#include "display/screen.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace brewster {

Screen Screen::window(int width, int height) {
    return Screen(width, height);
}

Screen Screen::off_screen(int width, int height) {
    Screen screen(width, height);
    screen.framebuffer_ = Framebuffer::create();
    screen.texture_ = Texture::create();
    glBindTexture(GL_TEXTURE_2D, screen.texture_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, screen.texture_.id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("the driver cannot draw " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
                    "graphics driver", "choose a smaller picture");
    }
    return screen;
}

void Screen::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
}

void Screen::clear() const {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Screen::clip(float from, float to) const {
    const auto left = static_cast<int>(std::lround(from * static_cast<float>(width_)));
    const auto right = static_cast<int>(std::lround(to * static_cast<float>(width_)));
    glEnable(GL_SCISSOR_TEST);
    glScissor(left, 0, right - left, height_);
}

void Screen::unclip() const {
    glDisable(GL_SCISSOR_TEST);
}

ScreenImage Screen::read() const {
    ScreenImage image{width_, height_, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(width_), rows = static_cast<std::size_t>(height_);
    std::vector<std::uint8_t> upside_down(row * rows);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    image.rgba.resize(row * rows);
    for (std::size_t y = 0; y < rows; ++y) {
        std::copy_n(upside_down.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row), row,
                    image.rgba.begin() + static_cast<std::ptrdiff_t>(y * row));
    }
    return image;
}

}  // namespace brewster
