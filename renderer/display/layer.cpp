#include "display/layer.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

std::vector<std::string> with_kind(LayerKind kind, std::vector<std::string> defines) {
    if (kind == LayerKind::stokes) defines.emplace_back("BREWSTER_STOKES");
    if (kind == LayerKind::cells) defines.emplace_back("BREWSTER_CELLS");
    return defines;
}

// A spare drawing is kept where it is so much larger or smaller, as pictures in motion are.
constexpr std::int64_t most_spare = 3;

std::int64_t area(const Layer::Drawing& drawing) {
    return std::int64_t{drawing.drawn.width()} * drawing.drawn.height();
}

}  // namespace

Layer::Layer(LayerKind kind, std::vector<std::string> defines)
    : kind_(kind),
      chart_program_("chart.vert", kind == LayerKind::cells ? "cells.frag" : "chart.frag",
                     with_kind(kind, std::move(defines))),
      accumulate_program_("full_screen.vert", "accumulate.frag", with_kind(kind, {})),
      no_vertices_(VertexArray::create()) {}

void Layer::resize(int width, int height) {
    const auto fits = [&](const Drawing& drawing) {
        return drawing.drawn.width() == width && drawing.drawn.height() == height;
    };
    if (fits(drawing_)) return;
    if (fits(spare_)) {
        std::swap(drawing_, spare_);
    } else {
        if (area(drawing_) > 0) spare_ = std::exchange(drawing_, {});
        drawing_.drawn = RenderTarget(width, height, drawn_textures(), true);
        drawing_.sums = RenderTarget(width, height, sum_textures(), false);
        const std::int64_t larger = std::max(area(drawing_), area(spare_)),
                           smaller = std::min(area(drawing_), area(spare_));
        if (most_spare * smaller > larger) spare_ = {};
    }
    forget();
}

void Layer::add_band(const std::function<void(const Program&)>& draw_charts, int bands) {
    const int height = drawing_.drawn.height();
    const int low = drawing_.rows_done, high = std::min(height, low + (height + bands - 1) / bands);
    drawing_.drawn.bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, low, drawing_.drawn.width(), high - low);
    drawing_.drawn.clear();
    draw_charts(chart_program_);
    accumulate();
    glDisable(GL_SCISSOR_TEST);
    drawing_.rows_done = high;
    if (drawing_.rows_done < height) return;
    drawing_.rows_done = 0;
    ++drawing_.draws;
}

void Layer::accumulate() {
    drawing_.sums.bind();
    if (drawing_.draws == 0) drawing_.sums.clear();
    constexpr std::array<const char*, 7> drawn = {"drawn_s0", "drawn_variance",        "drawn_s1",         "drawn_s2",
                                                  "drawn_s3", "drawn_variance_linear", "drawn_variance_s3"};
    for (int i = 0; i < drawn_textures(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, drawing_.drawn.texture(i));
        accumulate_program_.set(drawn[static_cast<std::size_t>(i)], i);
    }
    accumulate_program_.use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

Image Layer::stokes() const {
    BREWSTER_CHECK(drawing_.draws > 0 && kind_ != LayerKind::cells, std::to_string(drawing_.draws));
    Image image(drawing_.sums.width(), drawing_.sums.height());
    for (int component = 0; component < 4; ++component)
        for (int band = 0; band < 3; ++band) image.add_channel(stokes_channel(component, band));
    for (int component = 0; component < 4; ++component)
        for (int band = 0; band < 3; ++band) image.add_channel(variance_channel(component, band));
    const std::vector<float> counted = drawing_.sums.read(s0);
    const auto fill = [&](Sum sum, const auto& name, int component) {
        const std::vector<float> values = sum == s0 ? counted : drawing_.sums.read(sum);
        for (int band = 0; band < 3; ++band) {
            std::vector<float>& pixels = image.channel(name(component, band));
            for (std::size_t i = 0; i < pixels.size(); ++i)
                pixels[i] = values[4 * i + static_cast<std::size_t>(band)] / counted[4 * i + 3];
        }
    };
    fill(s0, stokes_channel, 0);
    fill(variance_s0, variance_channel, 0);
    add_spread(image, counted);
    if (kind_ == LayerKind::stokes) {
        fill(s1, stokes_channel, 1);
        fill(s2, stokes_channel, 2);
        fill(s3, stokes_channel, 3);
        fill(variance_linear, variance_channel, 1);
        fill(variance_linear, variance_channel, 2);
        fill(variance_s3, variance_channel, 3);
    }
    check_gl("reading the picture");
    return image;
}

void Layer::add_spread(Image& image, const std::vector<float>& counted) const {
    const std::vector<float> squares = drawing_.sums.read(squares_s0);
    for (int band = 0; band < 3; ++band) {
        const std::vector<float>& mean = image.channel(stokes_channel(0, band));
        std::vector<float>& variance = image.channel(variance_channel(0, band));
        for (std::size_t i = 0; i < mean.size(); ++i) {
            const auto n = static_cast<double>(counted[4 * i + 3]);
            if (n <= 1) continue;
            const double square = static_cast<double>(squares[4 * i + static_cast<std::size_t>(band)]) / n;
            const double spread = square - static_cast<double>(mean[i]) * static_cast<double>(mean[i]);
            variance[i] += static_cast<float>(std::max(0.0, spread) / (n - 1));
        }
    }
}

}  // namespace brewster
