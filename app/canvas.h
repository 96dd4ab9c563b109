#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/inspection.h"
#include "app/state.h"
#include "display/gathered_light.h"
#include "display/picture.h"
#include "display/screen.h"
#include "display/screen_pass.h"
#include "display/text.h"
#include "image/stokes_picture.h"

namespace brewster {

/// What stands beside the light in the picture.
struct Caption {
    std::string scene, camera;
    std::string status;  ///< a line at the top; empty: none
    bool legend = true;
    bool dimmed = false;  ///< what is shown is of a scene that is no longer
    float text_scale = 1;
};

/// The light in one world, or in both side by side, on the screen.
void show_sight(const ScreenPass& screen_pass, const Screen& screen, const LightTextures& light, const Sight& view,
                bool other_world);

/// The picture in the window: light from the bins, or from rays of the eye where they have been followed, and how it is
/// shown. Draws, but decides nothing.
class Canvas {
  public:
    explicit Canvas(std::shared_ptr<const Scene> scene);

    /// The same surfaces with other materials, or another scene altogether (what was drawn is lost).
    void repaint(std::shared_ptr<const Scene> scene);
    void open(std::shared_ptr<const Scene> scene);

    Picture& picture() { return *picture_; }
    const Picture& picture() const { return *picture_; }

    /// This, which ends in bins of so many photons, is shown as soon as it is uploaded, until the bins are to be shown
    /// again.
    void show_gathered(std::shared_ptr<const StokesPicture> picture, std::uint64_t photons);
    void show_bins() { gathered_ = arriving_ = nullptr; }
    bool arriving() const { return arriving_ != nullptr; }
    /// Uploads at most so many bytes of it. True when it is shown from now on.
    bool upload_gathered(std::size_t bytes);
    const StokesPicture* gathered() const { return gathered_.get(); }

    /// What must have been drawn to show the view: the world that is wanted, or both where they stand side by side.
    static Rendition needed(const Sight& view, bool other_world);

    void present(const Screen& screen, const Sight& view, bool other_world, const Caption& caption);

    /// The light of the pixels [low, high) of what is shown, whose size in pixels is `size`.
    std::optional<SeenLight> look_at(glm::ivec2 low, glm::ivec2 high, glm::ivec2 size, bool polarization) const;

  private:
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<Picture> picture_;
    std::shared_ptr<const StokesPicture> gathered_, arriving_;
    std::uint64_t gathered_photons_ = 0, arriving_photons_ = 0;
    GatheredLight gathered_light_;
    ScreenPass screen_pass_;
    Text text_;
};

}  // namespace brewster
