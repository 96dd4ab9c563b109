#pragma once
#include <cstddef>
#include <span>

#include "display/program.h"

namespace brewster {

enum class TexelFormat { uint2, float4 };
enum class TexelStorage { buffer_texture, rows };

/// Buffer textures where the driver allows ones of 2^26 texels and more, else rows of a 2-D texture: OpenGL 3.3
/// promises only 65536 texels. `largest_buffer_texture` below the driver's own limit lowers it.
TexelStorage texel_storage(std::size_t largest_buffer_texture);

/// The `#define` that shaders with bins.glsl need for this storage.
std::vector<std::string> texel_defines(TexelStorage storage);

/// A long array that shaders read by index, see shaders/bins.glsl.
class TexelArray {
  public:
    TexelArray(TexelFormat format, TexelStorage storage);

    /// Makes room for so many texels; growing forgets what was there. Throws Error beyond what the driver can hold.
    void reserve(std::size_t texels);
    /// Copies texels (8 or 16 bytes each) from `data` to the places from `first` on.
    void write(std::size_t first, std::size_t texels, const void* data);
    void bind(const Program& program, const std::string& uniform, int unit) const;

    std::size_t texel_bytes() const { return format_ == TexelFormat::uint2 ? 8 : 16; }

  private:
    void write_rows(std::size_t first, std::size_t texels, const std::byte* data);

    TexelFormat format_;
    TexelStorage storage_;
    std::size_t capacity_ = 0;
    Buffer buffer_;
    Texture texture_;
};

}  // namespace brewster
