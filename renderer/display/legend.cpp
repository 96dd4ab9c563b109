#include "display/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "display/legend_scale.h"

namespace brewster {
namespace {

constexpr glm::vec4 backing(0.0f, 0.0f, 0.0f, 0.6f);
constexpr glm::vec4 ink(1.0f, 1.0f, 1.0f, 1.0f);

std::string signed_number(float value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%+.1f", static_cast<double>(value));
    return digits;
}

/// `top_left` of a strip one line high and so many pixels wide, with its marks below.
void draw_strip(Text& text, const LegendScale& scale, glm::vec2 top_left, float width, int size) {
    const int columns = static_cast<int>(width), rows = scale.two_values ? size : 1;
    const float row_height = static_cast<float>(size) / static_cast<float>(rows);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            const float place = (static_cast<float>(column) + 0.5f) / static_cast<float>(columns);
            const float height = 1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
            text.add_rectangle(top_left + glm::vec2(column, static_cast<float>(row) * row_height), {1, row_height},
                               glm::vec4(scale.colour(place, height), 1.0f));
        }
    }
    const float line = static_cast<float>(size), below = top_left.y + line;
    std::vector<glm::vec2> places;  // of labels, from where to where
    for (const ScaleMark& mark : scale.marks) {
        const float x = top_left.x + width * static_cast<float>(mark.place), label = text.width(mark.label, size);
        text.add_rectangle({std::min(std::round(x), top_left.x + width - 1), below}, {1, std::round(0.3f * line)}, ink);
        const float left = std::clamp(x - 0.5f * label, top_left.x, top_left.x + width - label);
        places.emplace_back(left, left + label);
    }
    const std::vector<bool> readable = readable_labels(places, 0.4f * line);
    for (std::size_t k = 0; k < places.size(); ++k)
        if (readable[k]) text.add(scale.marks[k].label, {places[k].x, below + 0.25f * line}, size, ink);
}

}  // namespace

std::string brief_count(std::uint64_t count) {
    if (count < 1000) return std::to_string(count);
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.1e", static_cast<double>(count));
    const std::string text = digits;
    const std::string mantissa = text.substr(text.find('.') + 1, 1) == "0" ? text.substr(0, 1) : text.substr(0, 3);
    return mantissa + "e" + std::to_string(std::stoi(text.substr(text.find('e') + 1)));
}

std::string analyzer_words(const Analyzer& analyzer) {
    switch (analyzer.kind) {
        case Analyzer::Kind::none:
            break;
        case Analyzer::Kind::linear: {
            char words[64];
            std::snprintf(words, sizeof words, "analyzer %g\u00b0", analyzer.angle);
            return words;
        }
        case Analyzer::Kind::right:
            return "right circular analyzer";
        case Analyzer::Kind::left:
            return "left circular analyzer";
    }
    return {};
}

int legend_text_size(int screen_height, float text_scale, float content_scale) {
    const float letters = std::clamp(static_cast<float>(screen_height) / (45 * content_scale), 12.0f, 32.0f);
    const float pixels = text_scale * content_scale * std::floor(letters);
    return std::min(static_cast<int>(std::lround(pixels)), FontAtlas::largest);
}

void draw_legend(Text& text, const Screen& screen, const Legend& legend) {
    const int size = legend_text_size(screen.height(), legend.text_scale, legend.content_scale);
    const float line = static_cast<float>(size), pitch = std::round(1.25f * line), margin = std::round(0.5f * line);
    const Rendition& rendition = legend.rendition;
    const LegendScale scale = legend_scale(rendition);
    std::vector<std::string> lines = {
        legend.scene + " \u00b7 " + legend.camera,
        brief_count(legend.photons) + " photons \u00b7 EV " + signed_number(rendition.exposure)};
    std::string filter = analyzer_words(rendition.analyzer);
    if (!rendition.shows_polarized_world())
        filter += std::string(filter.empty() ? "" : " \u00b7 ") + "polarization off";
    if (!filter.empty()) lines.push_back(filter);
    lines.emplace_back(description(rendition.map).title);

    float strip = 14 * line;
    for (const std::string& words : lines) strip = std::max(strip, std::ceil(text.width(words, size)));
    const float text_height = static_cast<float>(lines.size()) * pitch;
    const glm::vec2 extent(strip + 2 * margin, text_height + (scale.colour ? 2.4f * line : 0.0f) + 2 * margin);
    const glm::vec2 corner(margin, static_cast<float>(screen.height()) - margin - extent.y);
    if (corner.y < margin || extent.x + 2 * margin > static_cast<float>(screen.width())) return;

    text.add_rectangle(corner, extent, backing);
    glm::vec2 pen = corner + margin;
    for (const std::string& words : lines) {
        text.add(words, pen, size, ink);
        pen.y += pitch;
    }
    if (scale.colour) draw_strip(text, scale, pen, strip, size);
    text.draw(screen);
}

}  // namespace brewster
