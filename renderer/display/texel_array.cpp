#include "display/texel_array.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace brewster {
namespace {

constexpr std::size_t ample_buffer_texture = std::size_t{1} << 26;
constexpr std::size_t row_bits =
    10;  ///< OpenGL 3.3 promises 1024 texels a side; wider rows are taken when there are any

std::size_t row_width() {
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    std::size_t bits = row_bits;
    while (bits < 12 && (std::size_t{2} << bits) <= static_cast<std::size_t>(side)) ++bits;
    return std::size_t{1} << bits;
}

std::size_t largest_array(TexelStorage storage) {
    GLint limit = 0;
    if (storage == TexelStorage::buffer_texture) {
        glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
        return static_cast<std::size_t>(limit);
    }
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    return static_cast<std::size_t>(limit) * row_width();
}

}  // namespace

TexelStorage texel_storage(std::size_t largest_buffer_texture) {
    const std::size_t texels = std::min(largest_buffer_texture, largest_array(TexelStorage::buffer_texture));
    return texels >= ample_buffer_texture ? TexelStorage::buffer_texture : TexelStorage::rows;
}

std::vector<std::string> texel_defines(TexelStorage storage) {
    if (storage == TexelStorage::buffer_texture) return {};
    return {"BREWSTER_TEXEL_ROW " + std::to_string(row_width()) + "u"};
}

TexelArray::TexelArray(TexelFormat format, TexelStorage storage)
    : format_(format), storage_(storage), texture_(Texture::create()) {
    if (storage_ == TexelStorage::buffer_texture) buffer_ = Buffer::create();
    reserve(1);
}

void TexelArray::reserve(std::size_t texels) {
    if (texels <= capacity_) return;
    const std::size_t largest = largest_array(storage_);
    if (texels > largest) {
        throw Error("the bins need " + std::to_string(texels) + " texels, the driver holds " + std::to_string(largest),
                    "graphics driver", "give the bins less memory");
    }
    capacity_ = std::min(std::max(texels, capacity_ + capacity_ / 2), largest);
    const GLint internal_format = format_ == TexelFormat::uint2 ? GL_RG32UI : GL_RGBA32F;
    if (storage_ == TexelStorage::buffer_texture) {
        glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
        glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(capacity_ * texel_bytes()), nullptr, GL_DYNAMIC_DRAW);
        glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
        glTexBuffer(GL_TEXTURE_BUFFER, static_cast<GLenum>(internal_format), buffer_.id());
        return;
    }
    const std::size_t width = row_width(), height = (capacity_ + width - 1) / width;
    const GLenum layout = format_ == TexelFormat::uint2 ? GL_RG_INTEGER : GL_RGBA;
    const GLenum type = format_ == TexelFormat::uint2 ? GL_UNSIGNED_INT : GL_FLOAT;
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0,
                 layout, type, nullptr);
    capacity_ = width * height;
}

void TexelArray::write(std::size_t first, std::size_t texels, const void* data) {
    BREWSTER_CHECK(first + texels <= capacity_, std::to_string(first) + " + " + std::to_string(texels));
    if (texels == 0) return;
    if (storage_ == TexelStorage::rows) return write_rows(first, texels, static_cast<const std::byte*>(data));
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.id());
    glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * texel_bytes()),
                    static_cast<GLsizeiptr>(texels * texel_bytes()), data);
}

void TexelArray::write_rows(std::size_t first, std::size_t texels, const std::byte* data) {
    const std::size_t width = row_width();
    const GLenum layout = format_ == TexelFormat::uint2 ? GL_RG_INTEGER : GL_RGBA;
    const GLenum type = format_ == TexelFormat::uint2 ? GL_UNSIGNED_INT : GL_FLOAT;
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    while (texels > 0) {
        const std::size_t column = first % width;
        const std::size_t rows = column == 0 ? std::max<std::size_t>(texels / width, 1) : 1;
        const std::size_t columns = std::min(texels, width - column);
        glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(column), static_cast<GLint>(first / width),
                        static_cast<GLsizei>(columns), static_cast<GLsizei>(rows), layout, type, data);
        first += columns * rows;
        texels -= columns * rows;
        data += columns * rows * texel_bytes();
    }
}

void TexelArray::bind(const Program& program, const std::string& uniform, int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(storage_ == TexelStorage::buffer_texture ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D, texture_.id());
    program.set(uniform, unit);
}

}  // namespace brewster
