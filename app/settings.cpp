#include "app/settings.h"

#include <algorithm>

#include "app/suggestion.h"
#include "base/error.h"
#include "scene/properties.h"

namespace brewster {
namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

template <class Owner>
std::vector<std::string> names_that_apply(std::span<const Property<Owner>> rows, const Owner& owner) {
    std::vector<std::string> names;
    for (const Property<Owner>& row : rows)
        if (row.applies(owner)) names.emplace_back(row.name);
    return names;
}

template <class Owner>
const Property<Owner>& known(const Property<Owner>* row, std::span<const Property<Owner>> rows, const Owner& owner,
                             const std::string& name) {
    if (row) return *row;
    const std::vector<std::string> names = names_that_apply(rows, owner);
    throw Error("there is no property '" + name + "'" + did_you_mean(name, names), owner.name,
                "it has " + listed(names));
}

void apply(Scene& scene, const Setting& setting) {
    const std::string where = setting.owner + "." + setting.property;
    const auto named = [&](const auto& owner) { return owner.name == setting.owner; };
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(), named);
    if (material != scene.materials.end()) {
        const Property<Material>& row =
            known(find_material_property(setting.property), material_properties(), *material, setting.property);
        const auto index = static_cast<std::uint32_t>(material - scene.materials.begin());
        return set_property(scene, index, row, parse_property(row.type, setting.value, where));
    }
    const auto lamp = std::find_if(scene.lamps.begin(), scene.lamps.end(), [&](const Lamp& candidate) {
        return candidate.kind != LampKind::area && named(candidate);
    });
    if (lamp != scene.lamps.end()) {
        const Property<Lamp>& row =
            known(find_lamp_property(setting.property), lamp_properties(), *lamp, setting.property);
        const auto index = static_cast<std::uint32_t>(lamp - scene.lamps.begin());
        return set_lamp_property(scene, index, row, parse_property(row.type, setting.value, where));
    }
    std::vector<std::string> names;
    for (const Material& candidate : scene.materials) names.push_back(candidate.name);
    for (const Lamp& candidate : scene.lamps)
        if (candidate.kind != LampKind::area) names.push_back(candidate.name);
    throw Error("there is no material or lamp '" + setting.owner + "'" + did_you_mean(setting.owner, names), scene.name,
                "it has " + listed(names));
}

}  // namespace

std::string setting_text(const Setting& setting) {
    return setting.owner + "." + setting.property + "=" + setting.value;
}

std::optional<Setting> parse_setting(std::string_view text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view place = text.substr(0, equals);
    const std::size_t dot = place.rfind('.');
    if (dot == std::string_view::npos) return {};
    Setting setting{std::string(place.substr(0, dot)), std::string(place.substr(dot + 1)),
                    std::string(text.substr(equals + 1))};
    if (setting.owner.empty() || setting.property.empty() || setting.value.empty()) return {};
    return setting;
}

void apply_settings(Scene& scene, const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) apply(scene, setting);
}

}  // namespace brewster
