#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace brewster {

/// What of the light a picture shows. The numbers stand in shaders/maps.glsl, too.
enum class Map { radiance, s1, s2, s3, dop, dolp, aolp, docp, type, difference, error, bins };

/// How a map's legend is made.
enum class Scale { radiance, signed_radiance, degree, angle, type, relative_error, none };

struct MapDescription {
    Map map;
    std::string_view name;   ///< on the command line
    std::string_view title;  ///< in the legend, with the unit
    Scale scale;
};

/// The table of maps, in the order they are offered.
inline constexpr std::array map_descriptions = {
    MapDescription{Map::radiance, "radiance", "radiance, cd/m\u00b2", Scale::radiance},
    MapDescription{Map::s1, "s1", "S1, cd/m\u00b2: + horizontal, \u2212 vertical", Scale::signed_radiance},
    MapDescription{Map::s2, "s2", "S2, cd/m\u00b2: + at 45\u00b0, \u2212 at 135\u00b0", Scale::signed_radiance},
    MapDescription{Map::s3, "s3", "S3, cd/m\u00b2: + right, \u2212 left circular", Scale::signed_radiance},
    MapDescription{Map::dop, "dop", "degree of polarization, %", Scale::degree},
    MapDescription{Map::dolp, "dolp", "degree of linear polarization, %", Scale::degree},
    MapDescription{Map::aolp, "aolp", "angle of linear polarization, \u00b0", Scale::angle},
    MapDescription{Map::docp, "docp", "degree of circular polarization, %", Scale::degree},
    MapDescription{Map::type, "type", "type, bright where polarized", Scale::type},
    MapDescription{Map::difference, "difference", "polarization on \u2212 off, cd/m\u00b2", Scale::signed_radiance},
    MapDescription{Map::error, "error", "relative standard error, %", Scale::relative_error},
    MapDescription{Map::bins, "bins", "bins, each its own colour", Scale::none},
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

/// The colours of the maps, defined in shaders/shared/map_colours.h with their sources.
enum class Palette { blue_orange, red_green, polanalyser };

struct PaletteDescription {
    Palette palette;
    std::string_view name;  ///< on the command line
};

inline constexpr std::array palette_descriptions = {
    PaletteDescription{Palette::blue_orange, "blue-orange"},
    PaletteDescription{Palette::red_green, "red-green"},
    PaletteDescription{Palette::polanalyser, "polanalyser"},
};

constexpr std::string_view palette_name(Palette palette) {
    return palette_descriptions[static_cast<std::size_t>(palette)].name;
}

constexpr std::optional<Palette> find_palette(std::string_view name) {
    for (const PaletteDescription& entry : palette_descriptions) {
        if (entry.name == name) return entry.palette;
    }
    return std::nullopt;
}

}  // namespace brewster
