#include "image/decode.h"

#include <gtest/gtest.h>
#include <stb_image_write.h>

#include <cstring>
#include <string>

namespace brewster {
namespace {

std::span<const unsigned char> span_of(const std::string& bytes) {
    return {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()};
}

std::string png_of(int width, int height, const std::vector<std::uint8_t>& rgba) {
    std::string bytes;
    const auto append = [](void* into, void* from, int count) {
        static_cast<std::string*>(into)->append(static_cast<const char*>(from), static_cast<std::size_t>(count));
    };
    stbi_write_png_to_func(append, &bytes, width, height, 4, rgba.data(), 4 * width);
    return bytes;
}

// Big-endian.
std::string word(std::uint32_t value) {
    std::string bytes;
    for (const unsigned shift : {24u, 16u, 8u, 0u}) bytes += static_cast<char>(value >> shift & 0xffu);
    return bytes;
}

TEST(Decode, PixelsComeBackRowByRow) {
    std::vector<std::uint8_t> rgba;
    for (std::uint8_t i = 0; i < 24; ++i) rgba.push_back(static_cast<std::uint8_t>(10 * i));
    const std::string png = png_of(3, 2, rgba);
    const auto size = encoded_size(span_of(png));
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 3);
    EXPECT_EQ(size->height, 2);
    EXPECT_EQ(decode_rgba(span_of(png)), rgba);
}

TEST(Decode, WhatIsNoPictureIsNothing) {
    const std::string png = png_of(2, 2, std::vector<std::uint8_t>(16, 200));
    for (const std::string& bytes : {std::string(), std::string("GIF89a"), std::string(1000, 'x'), png.substr(0, 40),
                                     png.substr(0, png.size() / 2), std::string("\xff\xd8\xff\xe0", 4)})
        EXPECT_FALSE(decode_rgba(span_of(bytes))) << bytes.size();
}

// 64 MiB of zeros, deflated a thousandfold by hand, behind a header of one pixel: the decoder must not unpack them.
TEST(Decode, SmallPicturesThatUnpackToManyBytesAreRefused) {
    constexpr int side = 4096;
    const std::string large = png_of(side, side, std::vector<std::uint8_t>(std::size_t{4} * side * side, 0));
    EXPECT_LT(large.size(), std::size_t{2} << 20);
    std::string bomb = large;
    bomb.replace(16, 8, word(1) + word(1));
    EXPECT_TRUE(encoded_size(span_of(bomb)));
    EXPECT_FALSE(decode_rgba(span_of(bomb)));
    EXPECT_TRUE(decode_rgba(span_of(large)));  // the same bytes are fine where the header announces them
}

// Every byte of a picture changed in several ways: pixels or nothing. The sanitizers watch.
TEST(Decode, ScratchedPicturesNeverCrash) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 4 * 17 * 9; ++i) rgba.push_back(static_cast<std::uint8_t>(i * i));
    std::string jpeg;
    const auto append = [](void* into, void* from, int count) {
        static_cast<std::string*>(into)->append(static_cast<const char*>(from), static_cast<std::size_t>(count));
    };
    stbi_write_jpg_to_func(append, &jpeg, 17, 9, 4, rgba.data(), 80);
    int read = 0, refused = 0;
    for (const std::string& picture : {png_of(17, 9, rgba), jpeg})
        for (std::size_t i = 0; i < picture.size(); ++i)
            for (const int change : {0xff, 0x01, 0x80, 0x10}) {
                std::string scratched = picture;
                scratched[i] = static_cast<char>(scratched[i] ^ change);
                const auto size = encoded_size(span_of(scratched));
                // The reader of textures refuses larger ones before it decodes them.
                if (size && (size->width > 8192 || size->height > 8192)) continue;
                decode_rgba(span_of(scratched)) ? ++read : ++refused;
            }
    EXPECT_GT(read, 100);
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace brewster
