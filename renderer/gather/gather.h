#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "bins/snapshot.h"
#include "gather/eye_scene.h"
#include "gather/eye_tracer.h"
#include "gather/pixel_sums.h"
#include "image/stokes_picture.h"

namespace brewster {

/// Asked by every thread after every few hundred draws, so it must be quick.
using StopAsked = std::function<bool()>;

/// Told of every tile that has got all the draws of a call, by the thread that drew it.
using TileDrawn = std::function<void(int tile)>;

/// A rectangle of a larger picture, by its upper left pixel in it.
struct PictureTile {
    int left = 0, top = 0;
    StokesPicture picture;
};

/// A camera's picture from rays of its own that end in the bins, both worlds at once, growing draw by draw.
///
/// Gather gather(std::make_shared<EyeScene>(scene));  gather.show(snapshot);  gather.look(camera, 640, 480);
/// gather.draw(64, threads, stop);  const StokesPicture picture = gather.picture();
///
/// The picture is a function of scene, bins, camera, size, seed and draws: neither threads nor the steps in which it was
/// drawn change it (but for the last bits, if it was stopped in between).
class Gather {
  public:
    /// The fewest draws of a pixel where others get more; so many are spent evenly first, to learn where errors are.
    static constexpr std::uint32_t pilot_draws = 16;
    /// So many of a pixel's draws believe the bins and do not go wide.
    static constexpr std::uint32_t plain_draws = 8;

    explicit Gather(std::shared_ptr<const EyeScene> scene, std::uint64_t seed = 1);

    /// The bins to end in. Draws made with fewer than half of their photons are forgotten, and so are all draws when
    /// the bins belong to another solution (fewer photons than before).
    void show(std::shared_ptr<const Snapshot> bins);

    /// From where and how large; another camera or size forgets the draws so far.
    void look(const Camera& camera, int width, int height);

    /// Draws until there are so many for each pixel on the mean, on so many threads. Up to twice pilot_draws all pixels
    /// get the same number, from there on those with larger errors get more. False when `stop` said so before: at
    /// once, keeping what there is. Needs bins and a look. `drawn` may ask for its tile, but for nothing else.
    bool draw(std::uint32_t mean_draws, unsigned threads, const StopAsked& stop, const TileDrawn& drawn = {});

    double draws() const;  ///< so far, per pixel on the mean
    StokesPicture picture() const;
    int tiles() const;  ///< of the picture, row by row
    /// That part of the picture, but that its variance is learned from the tile alone.
    PictureTile tile(int index) const;
    PictureError error() const;
    double coarse_share() const;  ///< of the light, what came from bins of gloss at the end of long paths

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    void forget();
    /// False when it was stopped.
    bool draw_tile(EyeTracer& tracer, int tile, const std::vector<std::uint32_t>& wanted, const StopAsked& stop);
    bool draw_to(const std::vector<std::uint32_t>& wanted, unsigned threads, const StopAsked& stop,
                 const TileDrawn& drawn);
    struct TileBounds {
        int left, top, right, bottom;
    };
    TileBounds bounds(int tile) const;

    std::shared_ptr<const EyeScene> scene_;
    std::uint64_t seed_;
    std::shared_ptr<const Snapshot> bins_;
    std::uint64_t first_photons_ = 0;  // of the bins of the first draws
    Camera camera_;
    int width_ = 0, height_ = 0;
    std::vector<PixelSum> pixels_;
    std::vector<float> importance_;  // empty until the pilot draws are made
    std::vector<std::unique_ptr<EyeTracer>> tracers_;
};

}  // namespace brewster
