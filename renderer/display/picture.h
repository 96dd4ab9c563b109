#pragma once
#include <cstddef>
#include <limits>
#include <memory>

#include "display/albedo_textures.h"
#include "display/chart_mesh.h"
#include "display/passage_table.h"
#include "display/program.h"
#include "display/render_target.h"
#include "display/screen.h"
#include "display/upload.h"
#include "image/image.h"
#include "scene/scene.h"

namespace brewster {

/// The scene as a camera sees it in the bins: the mean, in linear light, of draws that each look through another point
/// of the pixel. Needs a current context (OsmesaContext, or the window's after load_gl).
///
/// Headless:  Picture picture(scene);  picture.show(snapshot);  picture.upload();
///            picture.look(camera, width, height);  picture.draw(64);  write_stokes_exr(path, picture.stokes());
class Picture {
  public:
    static constexpr int full_draws = 64;  ///< what a picture at rest is made of by default
    static constexpr std::size_t all_bytes = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t frame_bytes = 8u << 20;  ///< to upload in one frame of a window

    /// Keeps a reference to the scene. `largest_buffer_texture` in texels makes the driver's limit smaller (for tests).
    explicit Picture(const Scene& scene, std::size_t largest_buffer_texture = all_bytes);

    /// The bins to draw next, made for this scene. The old ones stay until the new are uploaded.
    void show(std::shared_ptr<const Snapshot> bins);
    /// Uploads at most so many bytes. True when other bins are drawn from now on: the draws so far are forgotten.
    bool upload(std::size_t bytes = all_bytes);
    bool uploaded() const { return upload_.complete(); }

    /// The bins that are drawn; null before the first are uploaded (the picture is black then).
    const Snapshot* bins() const { return upload_.drawn(); }

    /// From where and how large; another camera or size forgets the draws so far.
    void look(const Camera& camera, int width, int height);

    /// Which world is drawn: light as it is, or as if no surface could tell polarizations apart. A change forgets the
    /// draws so far.
    void set_polarization(bool on);
    bool polarization() const { return polarization_; }

    /// Adds draws to the mean. The first looks through the pixels' centres, but 1/128 to the upper left, the next all
    /// over the pixels; 64, or a multiple, see edges best.
    void draw(int count = 1);
    int draws() const { return draws_; }
    void finish() const;  ///< returns when all is drawn, for measuring

    /// The mean of the draws: S0 .. S3 and V0 .. V3. V is the variance of the bins, which the draws share, plus that of
    /// the draws' mean as if they were independent: at edges their even spread does several times better.
    Image stokes() const;

    /// auto_exposure of what this camera sees in the unpolarized world, from a small picture of its own size: the same
    /// for every use of the bins. Forgets the draws so far.
    float exposure_of(const Camera& camera);

    /// Fills the screen with the mean of the draws at this exposure in EV, stretched where the sizes differ.
    void present(const Screen& screen, float exposure) const;

  private:
    void draw_once();

    const Scene& scene_;
    TexelStorage storage_;
    BinUpload upload_;
    const bool polarizes_;  // some surface does, so pictures have S1, S2, S3
    TexelArray materials_;
    PassageTable passages_;
    AlbedoTextures textures_;
    ChartMesh mesh_;
    Program chart_program_, accumulate_program_, screen_program_;
    VertexArray no_vertices_;
    RenderTarget drawn_, sums_;
    Camera camera_;
    int draws_ = 0;
    bool polarization_ = true;
};

}  // namespace brewster
