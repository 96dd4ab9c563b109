#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "scene/texture.h"

namespace brewster {

inline constexpr double steepest_slope = 0.8;  ///< m beyond which the lobes' theory does not hold
/// Gloss of a smaller slope m, and mirrors, are too narrow for bins: these would need more cells than there are photons.
/// They are filed coarsely, so that nothing that reflects is black.
inline constexpr float least_fine_slope = 0.0999f;
inline constexpr double least_index = 1.01;  ///< closer to air, an interface reflects less than 3e-5

enum class InterfaceKind : std::uint8_t { none, dielectric, conductor };
enum class Finish : std::uint8_t { smooth, beckmann, kirchhoff };

/// What light meets first: a boundary between air and the medium of index n - i k (k = 0 in a dielectric).
struct Interface {
    InterfaceKind kind = InterfaceKind::none;
    Finish finish = Finish::smooth;
    glm::vec3 n{1.5f}, k{0.0f};    ///< per band
    float slope = 0;               ///< rough: Beckmann's m = 2 sigma / tau, (0, 0.8]
    float rms_height = 0;          ///< Kirchhoff: sigma, micrometres
    float correlation_length = 0;  ///< Kirchhoff: tau, micrometres

    bool present() const { return kind != InterfaceKind::none; }
};

/// What becomes of light that enters. Lambert: only without an interface; polarized diffuse: only under a dielectric
/// (theory 5, under rough ones 3.9); transparent: refraction at a smooth dielectric.
enum class Base : std::uint8_t { black, lambert, polarized_diffuse, transparent };

enum class FilterKind : std::uint8_t { none, polarizer, retarder };

/// A sheet that light passes straight on, without an interface (theory 1.3).
struct Filter {
    FilterKind kind = FilterKind::none;
    float angle = 0;             ///< radians, of the polarizer's passing or the retarder's fast axis on the sheet
    glm::vec3 retardance{0.0f};  ///< radians per band, [0, 2 pi)
};

/// A surface's optics: an interface over a base, and light of its own. Per band red, green, blue.
struct Material {
    std::string name;
    Interface interface;
    Base base = Base::lambert;
    glm::vec3 albedo{0.8f};    ///< of the base, [0, 1]; 0 where it is black or transparent
    bool thin = false;         ///< transparent: a pane whose two faces are one surface, not the skin of a closed body
    Filter filter;             ///< with a base that is transparent and thin
    glm::vec3 emission{0.0f};  ///< radiance that leaves the surface, cd/m2
    bool double_sided = false;
    std::uint32_t texture = no_texture;  ///< in Scene::textures: multiplies the base's albedo, and alpha
    float alpha = 1, alpha_cutoff = 0;   ///< cut out where alpha times the texture's is below the cutoff; 0: nowhere

    /// Bins are too coarse to look at: gloss sharper than their finest, mirrors, and what light passes, where one would
    /// look straight through.
    bool beyond_bins() const {
        const bool sharp = interface.finish == Finish::smooth || interface.slope < least_fine_slope;
        return base == Base::transparent || (interface.present() && sharp);
    }
    bool emits() const { return emission.x > 0 || emission.y > 0 || emission.z > 0; }
};

/// Unpolarized reflectance of a smooth interface at normal incidence, per band: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
glm::vec3 normal_reflectance(const Interface& interface);

}  // namespace brewster
