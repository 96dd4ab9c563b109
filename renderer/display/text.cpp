#include "display/text.h"

#include <cmath>

#include "display/gl_context.h"

namespace brewster {
namespace {

constexpr std::array<float, 4> no_glyph = {-1, -1, -1, -1};
constexpr glm::vec4 backing(0.0f, 0.0f, 0.0f, 0.6f);
constexpr glm::vec4 ink(1.0f, 1.0f, 1.0f, 1.0f);

}  // namespace

Text::Font::Font(int size) : atlas(size), texture(Texture::create()) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, FontAtlas::side, FontAtlas::side, 0, GL_RED, GL_UNSIGNED_BYTE,
                 atlas.coverage().data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Text::Text() : program_("text.vert", "text.frag"), array_(VertexArray::create()), buffer_(Buffer::create()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, position)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, atlas)));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, colour)));
}

Text::Font& Text::font(int size) {
    return fonts_.try_emplace(size, size).first->second;
}

float Text::width(std::string_view utf8, int size) {
    return font(size).atlas.width(utf8);
}

void Text::add_quad(const std::array<float, 4>& place, const std::array<float, 4>& atlas, int size, glm::vec4 colour) {
    if (runs_.empty() || (size != 0 && runs_.back().size != 0 && runs_.back().size != size)) {
        runs_.push_back({size, vertices_.size(), 0});
    }
    if (runs_.back().size == 0) runs_.back().size = size;
    for (const auto& [x, y] : {std::pair{0, 1}, {2, 1}, {2, 3}, {0, 1}, {2, 3}, {0, 3}}) {
        const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
        vertices_.push_back({{place[i], place[j]}, {atlas[i], atlas[j]}, colour});
    }
    runs_.back().count += 6;
}

void Text::add(std::string_view utf8, glm::vec2 top_left, int size, glm::vec4 colour) {
    const FontAtlas& atlas = font(size).atlas;
    glm::vec2 pen(top_left.x, std::round(top_left.y) + atlas.ascent());
    for (const char32_t point : code_points(utf8)) {
        const Glyph& glyph = atlas.glyph(point);
        const float x = std::round(pen.x);
        add_quad({x + glyph.offset[0], pen.y + glyph.offset[1], x + glyph.offset[2], pen.y + glyph.offset[3]},
                 glyph.atlas, size, colour);
        pen.x += glyph.advance;
    }
}

void Text::add_rectangle(glm::vec2 top_left, glm::vec2 extent, glm::vec4 colour) {
    add_quad({top_left.x, top_left.y, top_left.x + extent.x, top_left.y + extent.y}, no_glyph, 0, colour);
}

void Text::add_label(std::string_view utf8, glm::vec2 top_left, int size) {
    const float margin = std::round(0.3f * static_cast<float>(size));
    const glm::vec2 extent(std::ceil(width(utf8, size)) + 2 * margin, static_cast<float>(size) + 2 * margin);
    add_rectangle(top_left, extent, backing);
    add(utf8, top_left + margin, size, ink);
}

void Text::draw(const Screen& screen) {
    screen.bind();
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
                 GL_STREAM_DRAW);
    program_.set("screen_size", glm::vec2(screen.width(), screen.height()));
    program_.set("glyphs", 0);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    for (const Run& run : runs_) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, run.size == 0 ? 0 : font(run.size).texture.id());
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(run.first), static_cast<GLsizei>(run.count));
    }
    glDisable(GL_BLEND);
    vertices_.clear();
    runs_.clear();
    check_gl("text");
}

}  // namespace brewster
