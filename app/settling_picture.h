#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gather/gather.h"

namespace brewster {

/// A tile of rays from the eye, and of how many photons the bins were that its first draws ended in.
struct GatheredTile {
    PictureTile part;
    std::uint64_t photons = 0;
};

/// What has come of a picture that rays of the eye settle tile by tile; a tile that comes again is better than before.
class SettlingPicture {
  public:
    explicit SettlingPicture(glm::ivec2 size);

    void count(const GatheredTile& tile);

    glm::ivec2 size() const { return size_; }
    /// Pixels [low, high) have all come.
    bool covers(glm::ivec2 low, glm::ivec2 high) const;
    bool whole() const { return pixels_ == draws_.size(); }
    double share() const { return static_cast<double>(pixels_) / static_cast<double>(draws_.size()); }
    /// Per pixel that has come, on the mean.
    double samples() const { return pixels_ > 0 ? samples_ / static_cast<double>(pixels_) : 0; }
    std::uint64_t photons() const { return photons_; }  ///< of the tile that came last

  private:
    glm::ivec2 size_;
    std::vector<float> draws_;  ///< mean over the tile, by pixel; 0: none has come
    std::size_t pixels_ = 0;    ///< that have come
    double samples_ = 0;        ///< of all of them
    std::uint64_t photons_ = 0;
};

}  // namespace brewster
