#pragma once
#include <future>
#include <memory>
#include <optional>

#include "display/picture.h"
#include "gather/glimpse.h"

namespace brewster {

/// What bins cannot show in the frames of a moving camera: a few rays, as many as the time of a frame allows. Getting
/// ready for a scene happens beside the window; until then, and in scenes without such surfaces, frames show bins alone.
class MovingGlimpse {
  public:
    /// The scene from now on.
    void open(std::shared_ptr<const Scene> scene);

    /// Adds it to what the picture draws next, from this camera, unless it is there already. `generation`: of the bins.
    void show(Picture& picture, const Camera& camera, std::uint64_t generation);
    void clear(Picture& picture);

  private:
    /// What the present one was seen of.
    struct Sight {
        Camera camera;
        int width = 0, height = 0;
        std::uint64_t photons = 0, generation = 0;
    };
    static bool same(const Sight& a, const Sight& b);

    std::future<std::unique_ptr<Glimpse>> making_;
    std::shared_ptr<const Scene> wanted_;
    std::unique_ptr<Glimpse> glimpse_;
    std::optional<Sight> seen_;
    double seconds_a_pixel_ = 1e-6;
};

}  // namespace brewster
