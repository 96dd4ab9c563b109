#include "app/canvas.h"

#include <algorithm>
#include <utility>

#include "display/legend.h"
#include "display/read_light.h"

namespace brewster {
namespace {

constexpr glm::vec4 veil(0.0f, 0.0f, 0.0f, 0.35f);

Rendition of_world(Rendition rendition, bool polarization) {
    rendition.polarization = polarization;
    return rendition;
}

Rendition shown_world(const Sight& view, bool other_world) {
    return of_world(view.rendition, view.rendition.polarization != other_world);
}

}  // namespace

void show_sight(const ScreenPass& screen_pass, const Screen& screen, const LightTextures& light, const Sight& view,
                bool other_world, bool over) {
    if (view.split && view.rendition.map != Map::bins) {
        screen.clip(0, view.split_at);
        screen_pass.show(screen, light, of_world(view.rendition, true), over);
        screen.clip(view.split_at, 1);
        screen_pass.show(screen, light, of_world(view.rendition, false), over);
        screen.unclip();
    } else {
        screen_pass.show(screen, light, shown_world(view, other_world), over);
    }
}

Canvas::Canvas(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), picture_(std::make_unique<Picture>(*scene_)) {}

void Canvas::repaint(std::shared_ptr<const Scene> scene) {
    picture_->repaint(*scene);
    scene_ = std::move(scene);
    show_bins();
}

void Canvas::open(std::shared_ptr<const Scene> scene) {
    auto picture = std::make_unique<Picture>(*scene);
    picture_ = std::move(picture);
    scene_ = std::move(scene);
    show_bins();
}

void Canvas::show_gathered(const std::vector<GatheredTile>& tiles, glm::ivec2 size) {
    if (!gathered_) gathered_.emplace(size);
    for (const GatheredTile& tile : tiles) {
        gathered_->count(tile);
        gathered_light_.put(tile.part.picture, tile.part.left, tile.part.top);
    }
}

void Canvas::show_bins() {
    gathered_.reset();
    gathered_light_.clear();
}

std::uint64_t Canvas::photons_shown() const {
    return settled() ? gathered_->photons() : picture_->bins() ? picture_->bins()->photons : 0;
}

Rendition Canvas::needed(const Sight& view, bool other_world) {
    Rendition rendition = shown_world(view, other_world);
    if (view.split && rendition.map != Map::bins) rendition.map = Map::difference;
    return rendition;
}

void Canvas::present(const Screen& screen, const Sight& view, bool other_world, const Caption& caption) {
    // Cells are not gathered.
    const bool of_rays = gathered_ && view.rendition.map != Map::bins;
    if (!of_rays || !settled()) show_sight(screen_pass_, screen, picture_->light(), view, other_world);
    if (of_rays) show_sight(screen_pass_, screen, gathered_light_.textures(), view, other_world, !settled());
    const int text_size = legend_text_size(screen.height(), caption.text_scale, caption.content_scale);
    if (caption.dimmed)
        text_.add_rectangle({0, 0}, {static_cast<float>(screen.width()), static_cast<float>(screen.height())}, veil);
    if (!caption.status.empty())
        text_.add_label(caption.status, glm::vec2(0.5f * static_cast<float>(text_size)), text_size);
    text_.draw(screen);
    if (!caption.legend || !picture_->bins()) return;
    draw_legend(text_, screen,
                {shown_world(view, other_world), caption.scene, caption.camera, photons_shown(), caption.text_scale,
                 caption.content_scale});
}

std::optional<SeenLight> Canvas::look_at(glm::ivec2 low, glm::ivec2 high, glm::ivec2 size, bool polarization) const {
    low = glm::max(low, glm::ivec2(0));
    high = glm::min(high, size);
    if (high.x <= low.x || high.y <= low.y) return {};
    if (gathered_ && gathered_->size() == size && gathered_->covers(low, high))
        return seen_light(read_light(gathered_light_.textures(), size.y, low, high), {0, 0}, high - low, polarization);
    Rendition world;
    world.polarization = polarization;
    if (picture_->draws(world) == 0) return {};
    // While the camera moves, the picture may be coarser than the screen.
    const glm::ivec2 drawn(picture_->width(), picture_->height());
    const glm::ivec2 first = low * drawn / size, last = glm::max(first + 1, (high * drawn + size - 1) / size);
    return seen_light(read_light(picture_->light(), drawn.y, first, last), {0, 0}, last - first, polarization);
}

}  // namespace brewster
