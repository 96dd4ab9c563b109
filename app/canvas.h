#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/inspection.h"
#include "app/settling_picture.h"
#include "app/state.h"
#include "display/gathered_light.h"
#include "display/picture.h"
#include "display/screen.h"
#include "display/screen_pass.h"
#include "display/text.h"

namespace brewster {

/// What stands beside the light in the picture.
struct Caption {
    std::string scene, camera;
    std::string status;  ///< a line at the top; empty: none
    bool legend = true;
    bool dimmed = false;  ///< what is shown is of a scene that is no longer
    float text_scale = 1, content_scale = 1;
};

/// The light in one world, or in both side by side, on the screen. `over`: what is there stays where there is no light.
void show_sight(const ScreenPass& screen_pass, const Screen& screen, const LightTextures& light, const Sight& view,
                bool other_world, bool over = false);

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

    /// These tiles of a picture of that size are shown in the bins' place from now on, until the bins are to be shown
    /// again.
    void show_gathered(const std::vector<GatheredTile>& tiles, glm::ivec2 size);
    void show_bins();
    /// A step towards room for such a picture, which takes too long for one frame; true once it is there.
    bool make_room(glm::ivec2 size) { return gathered_ || gathered_light_.make_room(size.x, size.y); }
    /// What is shown over the bins, or null.
    const SettlingPicture* gathered() const { return gathered_ ? &*gathered_ : nullptr; }
    /// Nothing of the bins is seen any more.
    bool settled() const { return gathered_ && gathered_->whole(); }
    std::uint64_t photons_shown() const;  ///< of the bins that what is shown ends in

    /// What must have been drawn to show the view: the world that is wanted, or both where they stand side by side.
    static Rendition needed(const Sight& view, bool other_world);

    void present(const Screen& screen, const Sight& view, bool other_world, const Caption& caption);

    /// The light of the pixels [low, high) of what is shown, whose size in pixels is `size`.
    std::optional<SeenLight> look_at(glm::ivec2 low, glm::ivec2 high, glm::ivec2 size, bool polarization) const;

  private:
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<Picture> picture_;
    std::optional<SettlingPicture> gathered_;
    GatheredLight gathered_light_;
    ScreenPass screen_pass_;
    Text text_;
};

}  // namespace brewster
