#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/units.h"
#include "image/image.h"
#include "optics/stokes.h"

namespace brewster {

/// Stokes vectors of all bands, in the camera's frame x = normalize(cross(ray, up)).
using PixelStokes = std::array<Stokes<double, 4>, band_count>;

/// Sums and sums of squares of what the paths to each pixel brought. One thread at a time may add to a pixel.
class StokesSums {
  public:
    StokesSums(int width, int height) : width_(width), height_(height), pixels_(size()) {}

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

    void add(std::size_t pixel, const PixelStokes& light) {
        Pixel& sums = pixels_[pixel];
        for (std::size_t band = 0; band < band_count; ++band)
            for (std::size_t j = 0; j < 4; ++j) {
                const double x = light[band].s[j];
                sums.sum[4 * band + j] += x;
                sums.squares[4 * band + j] += x * x;
            }
    }

    /// Adds the mean over `count` independent paths (those that added nothing to a pixel included) to S0.R .. S3.B of
    /// the picture, and the variance of that mean to V0.R .. V3.B; makes the channels that are missing.
    void add_to(Image& picture, std::uint64_t count) const;

  private:
    struct Pixel {
        std::array<double, 4 * band_count> sum{}, squares{};
    };
    int width_, height_;
    std::vector<Pixel> pixels_;
};

}  // namespace brewster
