#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// One --set: MATERIAL.PROPERTY=VALUE, or a lamp instead of the material. Names may hold dots and equal signs: the value
/// begins after the last "=", the property after the last dot before it.
struct Setting {
    std::string owner, property, value;
};

/// Nothing if a part is missing.
std::optional<Setting> parse_setting(std::string_view text);

/// The same backwards.
std::string setting_text(const Setting& setting);

/// Changes the scene, setting after setting. Throws Error, with the nearest name there is, for an owner or a property
/// that is not known, and for a value that does not fit.
void apply_settings(Scene& scene, const std::vector<Setting>& settings);

}  // namespace brewster
