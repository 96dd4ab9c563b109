#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

#include "display/albedo_textures.h"
#include "display/chart_mesh.h"
#include "display/glimpse_light.h"
#include "display/layer.h"
#include "display/light_textures.h"
#include "display/passage_table.h"
#include "display/rendition.h"
#include "display/upload.h"
#include "image/image.h"
#include "scene/scene.h"

namespace brewster {

/// The scene as a camera sees it in the bins: the mean, in linear light, of draws that each look through another point
/// of the pixel. Needs a current context (OsmesaContext, or the window's after load_gl).
///
/// Headless:  Picture picture(scene);  picture.show(snapshot);  picture.upload();
///            picture.look(camera, width, height);  picture.draw(64);  write_stokes_exr(path, picture.stokes());
/// For eyes:  ScreenPass().show(screen, picture.light(), rendition);
class Picture {
  public:
    static constexpr int full_draws = 64;  ///< what a picture at rest is made of by default
    static constexpr std::size_t all_bytes = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t frame_bytes = 8u << 20;  ///< to upload in one frame of a window

    /// Keeps a reference to the scene. `largest_buffer_texture` in texels makes the driver's limit smaller (for tests).
    explicit Picture(const Scene& scene, std::size_t largest_buffer_texture = all_bytes);

    /// The same surfaces with other materials: what display itself works out of them shows in the next draw. Keeps a
    /// reference to this scene instead. The draws so far are forgotten.
    void repaint(const Scene& scene);

    /// The bins to draw next, made for this scene. The old ones stay until the new are uploaded.
    void show(std::shared_ptr<const Snapshot> bins);
    /// Uploads at most so many bytes. True when other bins are drawn from now on: the draws so far are forgotten.
    bool upload(std::size_t bytes = all_bytes);
    bool uploaded() const { return upload_.complete(); }

    /// The bins that are drawn; null before the first are uploaded (the picture is black then).
    const Snapshot* bins() const { return upload_.drawn(); }

    /// From where and how large; another camera or size forgets the draws so far.
    void look(const Camera& camera, int width, int height);
    int width() const { return width_; }
    int height() const { return height_; }

    /// In the next draws, surfaces that bins cannot show (Material::beyond_bins) take their light from this picture of
    /// the same view, see GlimpseLight::upload. Until it is cleared. Both forget the draws so far.
    void show_glimpse(int width, int height, const std::vector<std::uint32_t>& chart,
                      const std::array<std::vector<glm::vec3>, plane_count>& light);
    void clear_glimpse();
    bool shows_glimpse() const { return glimpse_.shows(); }

    /// Adds draws of what the rendition looks at: one world, both, or the cells; each has a mean of its own, so that going
    /// back to a world costs nothing. The first draw looks through the pixels' centres, but 1/128 to the upper left, the
    /// next all over the pixels; 64, or a multiple, see edges best.
    void draw(int count = 1, const Rendition& rendition = {});
    /// A step towards one more draw, of which each takes so many: nobody has to wait for a whole one. Bands of rows, from
    /// below, that have it already show it.
    void draw_band(int bands, const Rendition& rendition);
    /// For measuring what looking into the bins costs: they say the same everywhere from now on, or what they hold.
    void make_flat(bool flat);

    /// Of all that the rendition looks at.
    int draws(const Rendition& rendition = {}) const;
    void finish() const;  ///< returns when all is drawn, for measuring

    /// What ScreenPass shows, for renditions that have been drawn.
    LightTextures light() const;

    /// The mean of the draws of one world: S0 .. S3 and V0 .. V3. V0 is the variance of the bins, which the draws share,
    /// plus that of the draws' mean as if they were independent: at edges their even spread does several times better.
    /// V1 to V3 are of the bins alone; V1 and V2 are the larger one of both.
    Image stokes(bool polarization = true) const;

    /// auto_exposure of what this camera sees in the unpolarized world, from a small picture of its own size: the same
    /// for every use of the bins. Leaves the picture as it is.
    float exposure_of(const Camera& camera);

  private:
    enum Part { polarized, unpolarized, cells };
    /// Which parts a rendition looks at.
    std::array<bool, 3> parts_of(const Rendition& rendition) const;
    /// Where the draws of a part are: without polarizing surfaces both worlds are one.
    Part place_of(Part part) const { return part == unpolarized && !polarizes_ ? polarized : part; }
    Layer& layer(Part part);
    const Layer* drawn_layer(Part part) const;
    void draw_part(Part part, int bands);
    void draw_charts(const Program& program, Part part, int index) const;
    void forget();

    void write_materials();

    const Scene* scene_;
    TexelStorage storage_;
    BinUpload upload_;
    bool polarizes_;  // some surface does, so pictures have S1, S2, S3
    TexelArray materials_;
    PassageTable passages_;
    AlbedoTextures textures_;
    ChartMesh mesh_;
    GlimpseLight glimpse_;
    std::array<std::optional<Layer>, 3> layers_;  // made when first drawn
    Camera camera_;
    int width_ = 0, height_ = 0;
    bool flat_ = false;
};

}  // namespace brewster
