#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string_view>
#include <vector>

#include "display/font_atlas.h"
#include "display/gl_object.h"
#include "display/program.h"
#include "display/screen.h"

namespace brewster {

/// Text and rectangles on top of a screen. Places are in pixels from the upper left, colours are sRGB codes with alpha.
/// What is added is drawn by the next `draw`, in the order it was added, and then forgotten.
class Text {
  public:
    Text();

    /// `size`: height of a line in pixels.
    float width(std::string_view utf8, int size);
    /// `top_left` of the line.
    void add(std::string_view utf8, glm::vec2 top_left, int size, glm::vec4 colour);
    void add_rectangle(glm::vec2 top_left, glm::vec2 extent, glm::vec4 colour);
    /// A line on a dark backing that keeps it readable on any picture.
    void add_label(std::string_view utf8, glm::vec2 top_left, int size);

    void draw(const Screen& screen);

  private:
    struct Vertex {
        glm::vec2 position;
        glm::vec2 atlas;  ///< texels; negative: no glyph, all covered
        glm::vec4 colour;
    };
    struct Font {
        FontAtlas atlas;
        Texture texture;
        explicit Font(int size);
    };
    /// Vertices in a row that share a font.
    struct Run {
        int size;
        std::size_t first, count;
    };
    Font& font(int size);
    void add_quad(const std::array<float, 4>& place, const std::array<float, 4>& atlas, int size, glm::vec4 colour);

    Program program_;
    VertexArray array_;
    Buffer buffer_;
    std::map<int, Font> fonts_;
    std::vector<Vertex> vertices_;
    std::vector<Run> runs_;
};

}  // namespace brewster
