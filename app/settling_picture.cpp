#include "app/settling_picture.h"

#include "base/check.h"

namespace brewster {

SettlingPicture::SettlingPicture(glm::ivec2 size)
    : size_(size), draws_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {}

void SettlingPicture::count(const GatheredTile& tile) {
    const StokesPicture& part = tile.part.picture;
    BREWSTER_CHECK(tile.part.left + part.width <= size_.x && tile.part.top + part.height <= size_.y,
                   "a tile of another picture");
    const auto draws = static_cast<float>(part.draws);
    for (int row = tile.part.top; row < tile.part.top + part.height; ++row) {
        float* first = &draws_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x)] + tile.part.left;
        for (float* at = first; at < first + part.width; ++at) {
            if (*at == 0) ++pixels_;
            samples_ += static_cast<double>(draws) - static_cast<double>(*at);
            *at = draws;
        }
    }
    photons_ = tile.photons;
}

bool SettlingPicture::covers(glm::ivec2 low, glm::ivec2 high) const {
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            if (draws_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x)] ==
                0)
                return false;
    return true;
}

}  // namespace brewster
