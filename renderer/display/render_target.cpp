#include "display/render_target.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/error.h"

namespace brewster {

RenderTarget::RenderTarget(int width, int height, int textures, bool depth)
    : width_(width), height_(height), framebuffer_(Framebuffer::create()) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw Error("cannot be drawn", "a picture of " + size + " pixels",
                    "choose a size from 1 x 1 to " + std::to_string(largest) + " x " + std::to_string(largest));
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    std::vector<GLenum> attachments;
    for (int i = 0; i < textures; ++i) {
        textures_.push_back(Texture::create());
        glBindTexture(GL_TEXTURE_2D, textures_.back().id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, textures_.back().id(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
    if (depth) {
        depth_ = Renderbuffer::create();
        glBindRenderbuffer(GL_RENDERBUFFER, depth_.id());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("the driver cannot draw float pictures of " + size + " pixels", "graphics driver",
                    "choose a smaller picture");
    }
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
}

void RenderTarget::clear() const {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | (depth_.id() != 0 ? GL_DEPTH_BUFFER_BIT : 0u));
}

std::vector<float> RenderTarget::read(int index) const {
    const std::size_t row = 4 * static_cast<std::size_t>(width_), rows = static_cast<std::size_t>(height_);
    std::vector<float> pixels(row * rows);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    for (std::size_t y = 0; y < rows / 2; ++y) {  // GL's first row is the lowest
        const auto low = pixels.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto high = pixels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row);
        std::swap_ranges(low, low + static_cast<std::ptrdiff_t>(row), high);
    }
    return pixels;
}

}  // namespace brewster
