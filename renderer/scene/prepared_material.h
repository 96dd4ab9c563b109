#pragma once
#include <array>
#include <memory>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "optics/rough_interface.h"
#include "scene/material.h"

namespace brewster {

/// A material with everything worked out that does not depend on directions: what bsdf.h evaluates and samples.
/// Kernels of one band use band 0.
class PreparedMaterial {
  public:
    /// Contradictions that the reader never makes are broken contracts: a Lambert base under an interface, a polarized
    /// diffuse one without a dielectric, a transparent one that is rough, a rough interface without roughness.
    PreparedMaterial(const Material& material, std::shared_ptr<const OrderRules> rules);

    InterfaceKind interface = InterfaceKind::none;
    Finish finish = Finish::smooth;
    Base base = Base::black;
    bool thin = false;
    bool achromatic = true;  ///< n and k are those of band 0 in all bands
    std::array<float, band_count> n{}, k{};
    float refracting_n = 1;  ///< transparent: mean of the bands, for all of them; no dispersion is simulated; air: 1
    float slope = 0;         ///< m
    std::array<float, band_count> phase{};  ///< Kirchhoff: 4 pi sigma / lambda
    /// Of the base: rho/(pi n^2 (1 - rho Fi)), 1/sr, and its share of entered power that leaves again.
    std::array<float, band_count> base_factor{}, base_survival{};
    std::array<float, band_count> external_reflectance{};  ///< Fe
    std::array<float, band_count> internal_reflectance{};  ///< Fi: of light that would leave the base
    std::array<float, band_count> inner_return{};          ///< rho Fi: what one bounce inside the base brings back
    glm::vec3 emission{0.0f};                              ///< cd/m2, unpolarized, the same in all directions
    FilterKind filter = FilterKind::none;                  ///< a sheet without an interface
    SineCosine<double> filter_turn{0, 1};                  ///< of its angle
    std::array<SineCosine<double>, band_count> retardance{};

    bool rough() const { return finish != Finish::smooth; }
    /// Light can enter and come back depolarized.
    bool diffuse() const { return base == Base::lambert || base == Base::polarized_diffuse; }
    /// Every way on is one direction: no lobe can be evaluated between two given directions.
    bool sharp() const { return !diffuse() && !rough(); }
    /// A sheet that light may cross without a change of direction: a pane or a filter.
    bool crossed_straight() const { return base == Base::transparent && thin; }
    /// Can reflect at the interface.
    bool reflects() const { return interface != InterfaceKind::none; }

    /// What the base lobe is multiplied by where a texture or the corners' colours multiply the albedo by `tint` in
    /// [0, 1]: the ratio of rho/(1 - rho Fi) there and here. The lobe's densities stay those of the material.
    template <class Real>
    Real tinted_base(std::size_t band, const Real& tint) const {
        const Real returned(inner_return[band]);
        return tint * (1 - returned) / (1 - tint * returned);
    }

    const OrderRules& rules() const { return *rules_; }

    template <class Real, std::size_t bands>
    KirchhoffSurface<Real, bands> kirchhoff() const {
        KirchhoffSurface<Real, bands> surface;
        surface.m = Real(slope);
        for (std::size_t band = 0; band < bands; ++band) surface.phase[band] = Real(phase[band]);
        return surface;
    }

    /// What the interface lets through to the base: without one everything, under rough ones 1 - E and -E1.
    template <class Real>
    Passage<Real> passage(std::size_t band, const Real& cos_theta) const {
        if (interface == InterfaceKind::none) return {Real(1), Real(0)};
        if (finish == Finish::smooth) return smooth_passage(cos_theta, Real(n[band]));
        return tables_[band]->passage(cos_theta);
    }

  private:
    std::shared_ptr<const OrderRules> rules_;
    std::array<std::shared_ptr<const RoughInterface>, band_count> tables_;
};

/// All materials of a scene, by their index there.
std::vector<PreparedMaterial> prepare_materials(const std::vector<Material>& materials);

}  // namespace brewster
