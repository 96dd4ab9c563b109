#include "app/material_summary.h"

#include "app/numbers.h"
#include "base/units.h"

namespace brewster {
namespace {

std::string number(float value) {
    return significant(static_cast<double>(value));
}

// One number where all bands agree.
std::string bands(glm::vec3 value) {
    if (value.x == value.y && value.y == value.z) return number(value.x);
    return number(value.x) + " " + number(value.y) + " " + number(value.z);
}

std::string described(const Interface& interface) {
    std::string text = interface_name(interface.kind) + " n " + bands(interface.n);
    if (interface.kind == InterfaceKind::conductor) text += ", k " + bands(interface.k);
    switch (interface.finish) {
        case Finish::smooth:
            return text + ", smooth";
        case Finish::beckmann:
            return text + ", rough with m " + number(interface.slope);
        case Finish::kirchhoff:
            return text + ", rough with heights of " + number(interface.rms_height) + " um rms over " +
                   number(interface.correlation_length) + " um (m " + number(interface.slope) + ")";
    }
    return text;
}

std::string described(const Filter& filter) {
    const std::string angle = significant(degrees(static_cast<double>(filter.angle))) + " degrees";
    if (filter.kind == FilterKind::polarizer) return "linear polarizer that passes light at " + angle;
    return "retarder of " + bands(filter.retardance * static_cast<float>(degrees(1.0))) +
           " degrees with its fast axis at " + angle;
}

}  // namespace

std::string base_name(Base base) {
    switch (base) {
        case Base::black:
            return "black";
        case Base::lambert:
            return "lambert";
        case Base::polarized_diffuse:
            return "polarized diffuse";
        case Base::transparent:
            return "transparent";
    }
    return "";
}

std::string interface_name(InterfaceKind kind) {
    switch (kind) {
        case InterfaceKind::none:
            return "none";
        case InterfaceKind::dielectric:
            return "dielectric";
        case InterfaceKind::conductor:
            return "conductor";
    }
    return "";
}

std::string finish_name(Finish finish) {
    switch (finish) {
        case Finish::smooth:
            return "smooth";
        case Finish::beckmann:
            return "beckmann";
        case Finish::kirchhoff:
            return "kirchhoff";
    }
    return "";
}

Polarizes polarizes(const Material& material) {
    if (material.filter.kind == FilterKind::polarizer) return {true, "it passes one linear state alone"};
    if (material.filter.kind == FilterKind::retarder)
        return {true, "it turns linear states into circular ones and back"};
    switch (material.interface.kind) {
        case InterfaceKind::conductor:
            return {true, "metal reflects s more than p and delays one against the other"};
        case InterfaceKind::dielectric:
            if (material.base == Base::transparent)
                return {true, "its interface reflects s more than p and lets p pass"};
            if (material.base == Base::polarized_diffuse)
                return {true, "its interface reflects s more than p, and light from its base leaves it p polarized"};
            return {true, "its interface reflects s more than p"};
        case InterfaceKind::none:
            break;
    }
    if (material.base == Base::lambert) return {false, "a Lambert surface depolarizes all light"};
    if (material.base == Base::transparent) return {false, "light passes as it is"};
    return {false, "nothing leaves it but its own light"};
}

std::string described(const Scene& scene, const Material& material) {
    std::string text;
    if (material.filter.kind != FilterKind::none) {
        text = described(material.filter);
    } else if (material.base == Base::lambert) {
        text = "Lambert, albedo " + bands(material.albedo);
    } else {
        text = material.interface.present() ? described(material.interface) : "no interface";
        if (material.base == Base::polarized_diffuse)
            text += ", over a diffuse base of albedo " + bands(material.albedo);
        if (material.base == Base::black && material.interface.kind != InterfaceKind::conductor)
            text += ", over a black base";
        if (material.base == Base::transparent) text += material.thin ? ", a thin clear pane" : ", a clear body";
    }
    if (material.texture != no_texture) {
        const SurfaceTexture& texture = scene.textures[material.texture];
        text += ", times a texture of " + std::to_string(texture.width) + " x " + std::to_string(texture.height) +
                " (mean " + bands(glm::vec3(texture_mean(texture))) + ")";
    }
    if (material.alpha_cutoff > 0) text += ", cut out where alpha is below " + number(material.alpha_cutoff);
    if (material.emits()) text += ", emits " + bands(material.emission) + " cd/m2";
    if (material.double_sided) text += ", both sides";
    return text;
}

}  // namespace brewster
