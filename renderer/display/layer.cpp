#include "display/layer.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

std::vector<std::string> with_kind(LayerKind kind, std::vector<std::string> defines) {
    if (kind == LayerKind::stokes) defines.emplace_back("BREWSTER_STOKES");
    if (kind == LayerKind::cells) defines.emplace_back("BREWSTER_CELLS");
    return defines;
}

}  // namespace

Layer::Layer(LayerKind kind, std::vector<std::string> defines)
    : kind_(kind),
      chart_program_("chart.vert", kind == LayerKind::cells ? "cells.frag" : "chart.frag",
                     with_kind(kind, std::move(defines))),
      accumulate_program_("full_screen.vert", "accumulate.frag", with_kind(kind, {})),
      no_vertices_(VertexArray::create()) {}

void Layer::resize(int width, int height) {
    if (width == drawn_.width() && height == drawn_.height()) return;
    drawn_ = RenderTarget(width, height, drawn_textures(), true);
    sums_ = RenderTarget(width, height, sum_textures(), false);
    forget();
}

void Layer::add(const std::function<void(const Program&)>& draw_charts) {
    next_band_ = 0;
    add_band(draw_charts, 1);
}

void Layer::add_band(const std::function<void(const Program&)>& draw_charts, int bands) {
    drawn_.bind();
    const int low = drawn_.height() * next_band_ / bands, high = drawn_.height() * (next_band_ + 1) / bands;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, low, drawn_.width(), high - low);
    drawn_.clear();
    draw_charts(chart_program_);
    glDisable(GL_SCISSOR_TEST);
    if (++next_band_ < bands) return;
    next_band_ = 0;
    accumulate();
}

void Layer::accumulate() {
    sums_.bind();
    if (draws_ == 0) sums_.clear();
    constexpr std::array<const char*, 7> drawn = {"drawn_s0", "drawn_variance",        "drawn_s1",         "drawn_s2",
                                                  "drawn_s3", "drawn_variance_linear", "drawn_variance_s3"};
    for (int i = 0; i < drawn_textures(); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, drawn_.texture(i));
        accumulate_program_.set(drawn[static_cast<std::size_t>(i)], i);
    }
    accumulate_program_.use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    ++draws_;
}

Image Layer::stokes() const {
    BREWSTER_CHECK(draws_ > 0 && kind_ != LayerKind::cells, std::to_string(draws_));
    Image image(sums_.width(), sums_.height());
    for (int component = 0; component < 4; ++component)
        for (int band = 0; band < 3; ++band) image.add_channel(stokes_channel(component, band));
    for (int component = 0; component < 4; ++component)
        for (int band = 0; band < 3; ++band) image.add_channel(variance_channel(component, band));
    const auto fill = [&](Sum sum, const auto& name, int component) {
        const std::vector<float> values = sums_.read(sum);
        for (int band = 0; band < 3; ++band) {
            std::vector<float>& pixels = image.channel(name(component, band));
            for (std::size_t i = 0; i < pixels.size(); ++i)
                pixels[i] = values[4 * i + static_cast<std::size_t>(band)] / static_cast<float>(draws_);
        }
    };
    fill(s0, stokes_channel, 0);
    fill(variance_s0, variance_channel, 0);
    if (draws_ > 1) add_spread(image);
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

void Layer::add_spread(Image& image) const {
    const double n = draws_;
    const std::vector<float> squares = sums_.read(squares_s0);
    for (int band = 0; band < 3; ++band) {
        const std::vector<float>& mean = image.channel(stokes_channel(0, band));
        std::vector<float>& variance = image.channel(variance_channel(0, band));
        for (std::size_t i = 0; i < mean.size(); ++i) {
            const double square = static_cast<double>(squares[4 * i + static_cast<std::size_t>(band)]) / n;
            const double spread = square - static_cast<double>(mean[i]) * static_cast<double>(mean[i]);
            variance[i] += static_cast<float>(std::max(0.0, spread) / (n - 1));
        }
    }
}

}  // namespace brewster
