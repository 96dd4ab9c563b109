#pragma once
#include <numbers>

namespace brewster {

/// Units: metres; radians inside, degrees at the surface; radiance per band in cd/m2 (white (1,1,1) = 1 cd/m2).
inline constexpr double pi = std::numbers::pi;
inline constexpr int band_count = 3;                                       ///< red, green, blue
inline constexpr double band_wavelength_nm[band_count] = {612, 549, 465};  ///< one wavelength a band

constexpr double radians(double degrees) {
    return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
    return radians * (180.0 / pi);
}

}  // namespace brewster
