#include "display/font_atlas.h"

#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "embedded_display.h"

namespace brewster {
namespace {

struct Range {
    int first, count;
};

/// ASCII, Latin-1, dashes and quotes, superscripts and subscripts, minus.
constexpr Range ranges[] = {{0x20, 95}, {0xa0, 96}, {0x2010, 24}, {0x2070, 32}, {0x2212, 1}};

const unsigned char* font_bytes() {
    return reinterpret_cast<const unsigned char*>(embedded::dejavu_sans().data());
}

}  // namespace

std::vector<char32_t> code_points(std::string_view utf8) {
    std::vector<char32_t> points;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(utf8[k]); };
        const unsigned lead = byte(i++);
        const std::size_t more = lead < 0x80   ? 0
                                 : lead < 0xc2 ? 9
                                 : lead < 0xe0 ? 1
                                 : lead < 0xf0 ? 2
                                 : lead < 0xf5 ? 3
                                               : 9;
        char32_t point = more == 0 ? lead : lead & (0x3fu >> more);
        std::size_t taken = 0;
        while (more < 9 && taken < more && i < utf8.size() && (byte(i) & 0xc0u) == 0x80u) {
            point = point << 6 | (byte(i++) & 0x3fu);
            ++taken;
        }
        points.push_back(taken == more ? point : U'\ufffd');
    }
    return points;
}

FontAtlas::FontAtlas(int pixels) : coverage_(std::size_t{side} * side) {
    BREWSTER_CHECK(pixels >= 6 && pixels <= largest, std::to_string(pixels));
    std::vector<std::vector<stbtt_packedchar>> packed;
    std::vector<stbtt_pack_range> requests;
    for (const Range& range : ranges) {
        packed.emplace_back(static_cast<std::size_t>(range.count));
        stbtt_pack_range request{};
        request.font_size = static_cast<float>(pixels);
        request.first_unicode_codepoint_in_range = range.first;
        request.num_chars = range.count;
        request.chardata_for_range = packed.back().data();
        requests.push_back(request);
    }
    stbtt_pack_context context;
    const bool ready = stbtt_PackBegin(&context, coverage_.data(), side, side, 0, 1, nullptr) != 0;
    const bool fits = ready && stbtt_PackFontRanges(&context, font_bytes(), 0, requests.data(),
                                                    static_cast<int>(requests.size())) != 0;
    stbtt_PackEnd(&context);
    stbtt_fontinfo font;
    int ascent = 0, descent = 0, gap = 0;
    BREWSTER_CHECK(stbtt_InitFont(&font, font_bytes(), 0) != 0, "embedded font");
    stbtt_GetFontVMetrics(&font, &ascent, &descent, &gap);
    ascent_ = std::round(static_cast<float>(ascent) * stbtt_ScaleForPixelHeight(&font, static_cast<float>(pixels)));
    for (std::size_t r = 0; r < packed.size(); ++r) {
        for (int k = 0; k < ranges[r].count; ++k) {
            const stbtt_packedchar& c = packed[r][static_cast<std::size_t>(k)];
            Glyph glyph;
            glyph.atlas = {static_cast<float>(c.x0), static_cast<float>(c.y0), static_cast<float>(c.x1),
                           static_cast<float>(c.y1)};
            const float x = std::round(c.xoff), y = std::round(c.yoff);
            glyph.offset = {x, y, x + glyph.atlas[2] - glyph.atlas[0], y + glyph.atlas[3] - glyph.atlas[1]};
            glyph.advance = c.xadvance;
            glyphs_.emplace_back(static_cast<char32_t>(ranges[r].first + k), glyph);
        }
    }
    BREWSTER_CHECK(fits, "glyphs of " + std::to_string(pixels) + " pixels do not fit the atlas");
}

const Glyph& FontAtlas::glyph(char32_t code_point) const {
    const auto find = [&](char32_t wanted) {
        return std::lower_bound(glyphs_.begin(), glyphs_.end(), wanted,
                                [](const auto& entry, char32_t value) { return entry.first < value; });
    };
    const auto found = find(code_point);
    return found != glyphs_.end() && found->first == code_point ? found->second : find(U'?')->second;
}

float FontAtlas::width(std::string_view utf8) const {
    float sum = 0;
    for (const char32_t point : code_points(utf8)) sum += glyph(point).advance;
    return sum;
}

std::string_view font_file() {
    return embedded::dejavu_sans();
}

}  // namespace brewster
