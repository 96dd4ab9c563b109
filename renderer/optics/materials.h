#pragma once
#include <array>
#include <string_view>

#include "base/units.h"

namespace brewster {

/// Optical constants n - i k of a medium in air at the three bands, red, green, blue.
struct OpticalConstants {
    std::string_view name;
    std::array<double, band_count> n, k;
    std::string_view source;
};

/// From dispersion formulas (dielectrics, absorption left out) or linear interpolation in wavelength (metals)
/// of the published data at 612, 549 and 465 nm.
inline constexpr std::array<OpticalConstants, 9> named_materials{{
    {"water", {1.33267, 1.33472, 1.33867}, {}, "Daimon and Masumura 2007, doi:10.1364/AO.46.003811, 20 C"},
    {"glass", {1.51583, 1.51857, 1.52401}, {}, "Schott N-BK7, Sellmeier formula of the data sheet"},
    {"diamond", {2.41448, 2.42311, 2.44098}, {}, "Peter 1923, doi:10.1007/BF01330487"},
    {"acrylic", {1.48953, 1.49265, 1.49905}, {}, "Sultanova et al. 2009, Acta Physica Polonica A 116, 585; PMMA, 20 C"},
    {"thesis", {10, 10, 10}, {}, "Sankaranarayanan 1997, figure 8.1: an index chosen for its reflectance"},
    {"aluminium", {1.048, 0.786, 0.528}, {6.487, 5.841, 4.943}, "McPeak et al. 2015, doi:10.1021/ph5004237"},
    {"silver", {0.059, 0.060, 0.047}, {4.111, 3.589, 2.803}, "Johnson and Christy 1972, doi:10.1103/PhysRevB.6.4370"},
    {"gold", {0.221, 0.428, 1.332}, {3.215, 2.460, 1.869}, "Johnson and Christy 1972, doi:10.1103/PhysRevB.6.4370"},
    {"copper", {0.355, 1.016, 1.247}, {3.136, 2.579, 2.456}, "Johnson and Christy 1972, doi:10.1103/PhysRevB.6.4370"},
}};

/// The medium of that name, or null.
constexpr const OpticalConstants* find_medium(std::string_view name) {
    for (const OpticalConstants& medium : named_materials)
        if (medium.name == name) return &medium;
    return nullptr;
}

}  // namespace brewster
