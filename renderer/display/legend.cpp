#include "display/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "display/tone.h"

namespace brewster {
namespace {

constexpr glm::vec4 backing(0.0f, 0.0f, 0.0f, 0.6f);
constexpr glm::vec4 ink(1.0f, 1.0f, 1.0f, 1.0f);

/// The strip runs over what the curve and eight bits tell apart, in exposed units.
constexpr double darkest = 0.0025, brightest = 32.0;

std::string number(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%g", value);
    return digits;
}

std::string signed_number(float value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%+.1f", static_cast<double>(value));
    return digits;
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

std::vector<double> scale_marks(double low, double high, int most) {
    std::vector<double> marks;
    const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const int step = std::max(1, (last - first + most) / most);
    for (int power = first; power <= last; power += step) marks.push_back(std::pow(10.0, power));
    return marks;
}

void draw_legend(Text& text, const Screen& screen, const Legend& legend) {
    const int size = std::clamp(screen.height() / 45, 12, 32);
    const float line = static_cast<float>(size), pitch = std::round(1.25f * line), margin = std::round(0.5f * line);
    const std::string title(description(legend.map).title);
    const std::string names = legend.scene + " \u00b7 " + legend.camera;
    const std::string state = brief_count(legend.photons) + " photons \u00b7 EV " + signed_number(legend.exposure) +
                              (legend.polarization ? "" : " \u00b7 polarization off");
    const float strip = std::max({14 * line, std::ceil(text.width(names, size)), std::ceil(text.width(state, size))});
    const glm::vec2 extent(strip + 2 * margin, 3.1f * pitch + 2.3f * line + 2 * margin);
    const glm::vec2 corner(margin, static_cast<float>(screen.height()) - margin - extent.y);
    if (corner.y < margin || extent.x + 2 * margin > static_cast<float>(screen.width())) return;

    text.add_rectangle(corner, extent, backing);
    glm::vec2 pen = corner + margin;
    text.add(names, pen, size, ink);
    pen.y += pitch;
    text.add(state, pen, size, ink);
    pen.y += pitch;
    text.add(title, pen, size, ink);
    pen.y += std::round(1.1f * pitch);

    const double scale = std::exp2(-static_cast<double>(legend.exposure));
    const double low = darkest * scale, high = brightest * scale;
    const auto columns = static_cast<int>(strip);
    for (int column = 0; column < columns; ++column) {
        const double radiance = low * std::pow(high / low, (column + 0.5) / columns);
        const glm::vec3 colour = tone::screen_colour(glm::vec3(static_cast<float>(radiance)), legend.exposure);
        text.add_rectangle(pen + glm::vec2(column, 0), {1, line}, glm::vec4(colour, 1.0f));
    }
    for (const double mark : scale_marks(low, high, 5)) {
        const float x = pen.x + strip * static_cast<float>(std::log(mark / low) / std::log(high / low));
        const std::string label = number(mark);
        const float width = text.width(label, size);
        text.add_rectangle({std::round(x), pen.y + line}, {1, std::round(0.3f * line)}, ink);
        text.add(label, {std::clamp(x - 0.5f * width, pen.x, pen.x + strip - width), pen.y + 1.25f * line}, size, ink);
    }
    text.draw(screen);
}

}  // namespace brewster
