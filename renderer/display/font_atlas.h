#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace brewster {

/// The code points of UTF-8 text; broken bytes become U+FFFD.
std::vector<char32_t> code_points(std::string_view utf8);

/// A glyph's rectangle: in the atlas (texels), relative to the pen on the baseline (pixels, y down), and its advance.
struct Glyph {
    std::array<float, 4> atlas{};  ///< x0 y0 x1 y1
    std::array<float, 4> offset{};
    float advance = 0;
};

/// The embedded font (DejaVu Sans) at one size: Latin-1, dashes, quotes, superscripts, minus and a few signs more.
/// What is outside of these is shown as '?'.
class FontAtlas {
  public:
    static constexpr int side = 512;    ///< texels
    static constexpr int largest = 48;  ///< pixels

    /// `pixels`: height of a line from ascender to descender, 6 to `largest`.
    explicit FontAtlas(int pixels);

    const Glyph& glyph(char32_t code_point) const;
    float width(std::string_view utf8) const;  ///< pixels
    float ascent() const { return ascent_; }   ///< pixels from a line's top to its baseline
    const std::vector<std::uint8_t>& coverage() const { return coverage_; }

  private:
    std::vector<std::uint8_t> coverage_;
    std::vector<std::pair<char32_t, Glyph>> glyphs_;  ///< ascending
    float ascent_ = 0;
};

/// DejaVu Sans as a TrueType file, for those who make glyphs of their own.
std::string_view font_file();

}  // namespace brewster
