#pragma once
#include <limits>
#include <memory>
#include <span>

#include "bins/snapshot.h"
#include "gather/eye_level.h"
#include "gather/eye_numbers.h"
#include "scene/camera.h"

namespace brewster {

/// One look through a pixel.
struct Draw {
    std::uint16_t column = 0, row = 0;
    EyeNumbers numbers;
    /// At the first glass that is seen, what it reflects and what it lets through are both followed, the weaker one with
    /// so many times its share as probability. Where little is reflected, following it always costs more than it tells;
    /// but one draw alone looks best so. 0: one of both.
    float eagerness = 4;
    /// Where the bins err by more than this share of a surface's light (and more than most of them), rays take their place:
    /// one that gathers the indirect light of what is seen, and shadow rays for what a lobe or such a ray meets.
    float tolerance = std::numeric_limits<float>::infinity();
    /// At the first rough gloss every sixteenth draw that has not parted has a second ray, by the cosine, for what glares
    /// where the lobe hardly ever points. Not for single looks: it is worth its noise where many draws are averaged.
    bool goes_wide = false;
    bool reads_bins = false;  ///< what the bins alone say is wanted, too, where the draw meets rough gloss first
};

/// What the bins alone say of the light of those draws that asked for it and met rough gloss first.
struct BinsAlone {
    LevelLight light;
    std::array<bool, most_rays> known;
};

/// What a batch's time goes into, in this order at each depth.
enum class EyeStage { hits, bins, lamps, onwards, back };
inline constexpr std::size_t eye_stage_count = 5;
using EyeStageSeconds = std::array<double, eye_stage_count>;

/// Follows rays from the eye until they end in the bins, a batch of draws at a time: direct light by shadow rays,
/// indirect light from the bins; one ray for the gloss of any width, with multiple importance sampling against the
/// lamps; mirrors, and at glass both what it reflects and what it lets through. What a rough lobe meets is read from the
/// bins, direct and indirect. Draws may doubt what the bins say of contacts and shadows (Draw::tolerance). One per thread.
/// What a draw sees depends on its numbers alone, not on the others of its batch. What it never finds: the gloss of a lamp
/// without extent that shines there by way of glass or a mirror.
class EyeTracer {
  public:
    EyeTracer();
    ~EyeTracer();

    /// At most eye_batch draws. `alone`: needed where draws read bins.
    void trace(const EyeScene& scene, const Snapshot& bins, const Camera& camera, int width, int height,
               std::span<const Draw> draws, LevelLight& seen, BinsAlone* alone = nullptr);

    const EyeStageSeconds& stage_seconds() const;  ///< so far, for measurements

  private:
    template <int components>
    class Batch;
    struct Storage;
    std::unique_ptr<Storage> storage_;
};

}  // namespace brewster
