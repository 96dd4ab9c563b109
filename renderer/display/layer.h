#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "display/program.h"
#include "display/render_target.h"
#include "image/image.h"

namespace brewster {

/// What draws of the bins look at: the polarized world's Stokes vectors or, where nothing polarizes, its radiance; the
/// other world's radiance; the cells.
enum class LayerKind { stokes, radiance, cells };

/// One picture that grows draw by draw on the graphics side, as sums over the draws.
class Layer {
  public:
    /// `defines`: how the bins are stored (texel_defines).
    Layer(LayerKind kind, std::vector<std::string> defines);

    /// Another size forgets the draws so far.
    void resize(int width, int height);
    void forget() { drawing_.draws = drawing_.rows_done = 0; }

    /// Adds what `draw_charts` draws with the program it is given.
    void add(const std::function<void(const Program&)>& draw_charts) { add_band(draw_charts, 1); }
    /// The same of the next of so many bands of rows, from below; the rest of the rows have a draw less meanwhile.
    void add_band(const std::function<void(const Program&)>& draw_charts, int bands);

    int draws() const { return drawing_.draws; }  ///< that all pixels have

    /// What has been drawn. Another can take its place for a while.
    struct Drawing {
        RenderTarget drawn, sums;
        int draws = 0, rows_done = 0;  ///< of the next draw
    };
    Drawing exchange(Drawing other) { return std::exchange(drawing_, std::move(other)); }
    LayerKind kind() const { return kind_; }

    /// The sums, in the order of shaders/accumulate.frag. The alpha of S0 is the number of a pixel's draws.
    enum Sum { s0, squares_s0, variance_s0, s1, s2, s3, variance_linear, variance_s3 };
    GLuint texture(Sum sum) const { return drawing_.sums.texture(sum); }

    /// The mean of the draws as channels S0.R .. V3.B, see Picture::stokes; not of cells.
    Image stokes() const;

  private:
    void accumulate();
    /// Of the draws of S0, whose sums are given, to its variance.
    void add_spread(Image& image, const std::vector<float>& counted) const;
    int drawn_textures() const { return kind_ == LayerKind::stokes ? 7 : kind_ == LayerKind::radiance ? 2 : 1; }
    int sum_textures() const { return kind_ == LayerKind::stokes ? 8 : kind_ == LayerKind::radiance ? 3 : 1; }

    LayerKind kind_;
    Program chart_program_, accumulate_program_;
    VertexArray no_vertices_;
    Drawing drawing_, spare_;  ///< the latter of another size: making room takes long
};

}  // namespace brewster
