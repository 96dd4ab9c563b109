#include "scene/prepared_material.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "base/check.h"

namespace brewster {
namespace {

void check(const Material& material) {
    const Interface& interface = material.interface;
    const bool smooth = interface.finish == Finish::smooth;
    BREWSTER_CHECK(material.base != Base::lambert || !interface.present(), material.name);
    BREWSTER_CHECK(material.base != Base::polarized_diffuse || interface.kind == InterfaceKind::dielectric,
                   material.name);
    BREWSTER_CHECK(material.base != Base::transparent || (interface.kind != InterfaceKind::conductor && smooth),
                   material.name);
    BREWSTER_CHECK(interface.present() || smooth, material.name);
    BREWSTER_CHECK(material.filter.kind == FilterKind::none ||
                       (material.base == Base::transparent && material.thin && !interface.present()),
                   material.name);
    BREWSTER_CHECK(interface.finish != Finish::beckmann || interface.slope > 0, material.name);
    BREWSTER_CHECK(
        interface.finish != Finish::kirchhoff || (interface.rms_height > 0 && interface.correlation_length > 0),
        material.name);
}

}  // namespace

PreparedMaterial::PreparedMaterial(const Material& material, std::shared_ptr<const OrderRules> rules)
    : rules_(std::move(rules)) {
    check(material);
    const Interface& from = material.interface;
    interface = from.kind;
    finish = from.finish;
    base = material.base;
    thin = material.thin;
    emission = material.emission;
    slope = from.finish == Finish::kirchhoff ? 2 * from.rms_height / from.correlation_length : from.slope;
    for (std::size_t band = 0; band < band_count; ++band) {
        const auto at = static_cast<int>(band);
        n[band] = from.present() ? from.n[at] : 1.0f;
        k[band] = from.kind == InterfaceKind::conductor ? from.k[at] : 0.0f;
        achromatic = achromatic && n[band] == n[0] && k[band] == k[0];
        phase[band] = static_cast<float>(4e3 * pi * static_cast<double>(from.rms_height) / band_wavelength_nm[band]);
    }
    refracting_n = (n[0] + n[1] + n[2]) / 3.0f;
    filter = material.filter.kind;
    const auto angle = static_cast<double>(material.filter.angle);
    filter_turn = {std::sin(angle), std::cos(angle)};
    for (std::size_t band = 0; band < band_count; ++band) {
        const auto phase_shift = static_cast<double>(material.filter.retardance[static_cast<int>(band)]);
        retardance[band] = {std::sin(phase_shift), std::cos(phase_shift)};
    }
    if (!diffuse()) return;

    for (std::size_t band = 0; band < band_count; ++band) {
        const auto index = static_cast<double>(n[band]);
        const auto rho = static_cast<double>(material.albedo[static_cast<int>(band)]);
        double external = 0;
        if (finish == Finish::kirchhoff) {  // differs between bands even where n does not
            tables_[band] = std::make_shared<RoughInterface>(
                index, *rules_,
                KirchhoffSurface<double, 1>{static_cast<double>(slope), {static_cast<double>(phase[band])}});
            external = tables_[band]->external_reflectance();
        } else if (finish == Finish::beckmann) {
            tables_[band] = band > 0 && n[band] == n[0]
                                ? tables_[0]
                                : std::make_shared<const RoughInterface>(index, static_cast<double>(slope));
            external = tables_[band]->external_reflectance();
        } else if (interface == InterfaceKind::dielectric) {
            external = brewster::external_reflectance(index);
        }
        const double internal = brewster::internal_reflectance(external, index);
        internal_reflectance[band] = static_cast<float>(internal);
        external_reflectance[band] = static_cast<float>(external);
        inner_return[band] = static_cast<float>(rho * internal);
        base_factor[band] = static_cast<float>(base_radiance_factor(rho, index, internal));
        base_survival[band] = static_cast<float>(brewster::base_survival(rho, internal));
    }
}

std::vector<PreparedMaterial> prepare_materials(const std::vector<Material>& materials) {
    // They take ten milliseconds, and few scenes ask them.
    const bool any_kirchhoff = std::any_of(materials.begin(), materials.end(), [](const Material& material) {
        return material.interface.finish == Finish::kirchhoff;
    });
    const auto rules = any_kirchhoff ? std::make_shared<const OrderRules>() : nullptr;
    std::vector<PreparedMaterial> prepared;
    prepared.reserve(materials.size());
    for (const Material& material : materials) prepared.emplace_back(material, rules);
    return prepared;
}

}  // namespace brewster
