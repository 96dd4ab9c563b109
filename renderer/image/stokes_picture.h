#pragma once
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"

namespace brewster {

/// What a picture of both worlds holds of each pixel: the Stokes vector of the polarized world, in the camera's frame (see
/// write_stokes_exr), and the radiance of the world where no surface can tell polarizations apart.
enum class Plane { s0, s1, s2, s3, unpolarized };
inline constexpr std::size_t plane_count = 5;

/// Linear light of both worlds that a camera sees, cd/m2 per band (red, green, blue), and its variance; row 0 on top.
/// Analyzer, maps, exposure and legend act on this, whoever made it; choosing a world or a map needs no new rays.
struct StokesPicture {
    StokesPicture() = default;
    /// Zero everywhere.
    StokesPicture(int width_in_pixels, int height_in_pixels);

    int width = 0, height = 0;
    double draws = 0;  ///< mean number per pixel
    /// By plane, then by pixel. The variance is that of the mean shown: of the draws and of the bins they end in.
    std::array<std::vector<glm::vec3>, plane_count> light, variance;
    /// Of s0 - unpolarized: less than the sum of both, since the two worlds share their paths.
    std::vector<glm::vec3> difference_variance;

    std::size_t pixel_count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    std::vector<glm::vec3>& of(Plane plane) { return light[static_cast<std::size_t>(plane)]; }
    const std::vector<glm::vec3>& of(Plane plane) const { return light[static_cast<std::size_t>(plane)]; }
    std::vector<glm::vec3>& variance_of(Plane plane) { return variance[static_cast<std::size_t>(plane)]; }
    const std::vector<glm::vec3>& variance_of(Plane plane) const { return variance[static_cast<std::size_t>(plane)]; }
};

/// A file's picture: S0.R .. V3.B, or R G B alone; what is missing is zero. Its one world is taken for both, so that
/// whatever world one looks at is the file's. Throws Error without any radiance.
StokesPicture stokes_picture(const Image& image);

/// One world as named channels S0.R .. V3.B, ready for write_stokes_exr. Without polarization S1 to S3 are zero.
Image stokes_image(const StokesPicture& picture, bool polarization);

}  // namespace brewster
