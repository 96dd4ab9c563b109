#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace brewster {

/// What of the light a picture shows.
enum class Map { radiance };

struct MapDescription {
    Map map;
    std::string_view name;   ///< on the command line
    std::string_view title;  ///< in the legend, with the unit
};

/// The table of maps, in the order they are offered.
inline constexpr std::array map_descriptions = {
    MapDescription{Map::radiance, "radiance", "radiance, cd/m\u00b2"},
};

constexpr const MapDescription& description(Map map) {
    return map_descriptions[static_cast<std::size_t>(map)];
}

/// The map of that name.
constexpr std::optional<Map> find_map(std::string_view name) {
    for (const MapDescription& entry : map_descriptions) {
        if (entry.name == name) return entry.map;
    }
    return std::nullopt;
}

}  // namespace brewster
