#include "image/jpeg.h"

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

namespace brewster {
namespace {

// libjpeg reports faults by leaving: back to where the reading began.
struct Fault {
    jpeg_error_mgr manager;
    std::jmp_buf begin;
};

[[noreturn]] void leave(j_common_ptr state) {
    std::longjmp(reinterpret_cast<Fault*>(state->err)->begin, 1);
}

void say_nothing(j_common_ptr, int) {}

// Reads the header and, if `rgba` is given, the pixels into it. False for what is no JPEG of grey or coloured pixels.
bool read_jpeg(std::span<const unsigned char> encoded, EncodedSize& size, std::vector<std::uint8_t>* rgba) {
    jpeg_decompress_struct state;
    Fault fault;
    state.err = jpeg_std_error(&fault.manager);
    fault.manager.error_exit = leave;
    fault.manager.emit_message = say_nothing;
    if (setjmp(fault.begin) != 0) {
        jpeg_destroy_decompress(&state);
        return false;
    }
    jpeg_create_decompress(&state);
    state.mem->max_memory_to_use = 1L << 30;
    jpeg_mem_src(&state, encoded.data(), static_cast<unsigned long>(encoded.size()));
    jpeg_read_header(&state, TRUE);
    size = {static_cast<int>(state.image_width), static_cast<int>(state.image_height)};
    if (rgba) {
        state.out_color_space = JCS_EXT_RGBA;  // a fault for CMYK
        jpeg_start_decompress(&state);
        rgba->resize(4 * size.texels());
        while (state.output_scanline < state.output_height) {
            JSAMPROW row = rgba->data() + std::size_t{4} * state.output_width * state.output_scanline;
            jpeg_read_scanlines(&state, &row, 1);
        }
    }
    jpeg_destroy_decompress(&state);
    return true;
}

}  // namespace

std::optional<EncodedSize> jpeg_size(std::span<const unsigned char> encoded) {
    EncodedSize size;
    if (!read_jpeg(encoded, size, nullptr)) return {};
    return size;
}

std::optional<std::vector<std::uint8_t>> decode_jpeg(std::span<const unsigned char> encoded) {
    EncodedSize size;
    std::vector<std::uint8_t> rgba;
    if (!read_jpeg(encoded, size, &rgba)) return {};
    return rgba;
}

}  // namespace brewster
