#include "display/shader_source.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "embedded_display.h"

namespace brewster {
namespace {

struct EmbeddedFile {
    std::string_view name;
    std::string_view (*text)();
};

constexpr EmbeddedFile embedded_files[] = {
    {"accumulate.frag", embedded::accumulate_frag},
    {"bins.glsl", embedded::bins_glsl},
    {"cells.frag", embedded::cells_frag},
    {"chart.frag", embedded::chart_frag},
    {"chart.glsl", embedded::chart_glsl},
    {"chart.vert", embedded::chart_vert},
    {"full_screen.vert", embedded::full_screen_vert},
    {"maps.glsl", embedded::maps_glsl},
    {"screen.frag", embedded::screen_frag},
    {"text.frag", embedded::text_frag},
    {"text.vert", embedded::text_vert},
    {"shared/bin_layout.h", embedded::bin_layout_h},
    {"shared/direction_map.h", embedded::direction_map_h},
    {"shared/gloss_lookup.h", embedded::gloss_lookup_h},
    {"shared/lookup.h", embedded::lookup_h},
    {"shared/map_colours.h", embedded::map_colours_h},
    {"shared/stokes.h", embedded::stokes_h},
    {"shared/tone.h", embedded::tone_h},
};

std::string& shader_folder() {
    static std::string folder;
    return folder;
}

std::string text_of(const std::string& name) {
    if (shader_folder().empty()) {
        const auto* found = std::find_if(std::begin(embedded_files), std::end(embedded_files),
                                         [&](const EmbeddedFile& file) { return file.name == name; });
        if (found != std::end(embedded_files)) return std::string(found->text());
        throw Error("there is no such shader in the program", name, "include one of its own shaders");
    }
    const std::string path = shader_folder() + "/" + name;
    std::ifstream file(path);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) throw Error("cannot be read", path, "check the folder of --shader-dir");
    return text.str();
}

void splice(const std::string& name, ShaderSource& source) {
    const std::size_t index = source.files.size();
    source.files.push_back(name);
    const auto begin_line = [&](int line) {
        source.text += "#line " + std::to_string(line) + " " + std::to_string(index) + "\n";
    };
    constexpr std::string_view directive = "#include \"";
    std::istringstream lines(text_of(name));
    begin_line(1);
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number) {
        if (!line.starts_with(directive)) {
            source.text += line + "\n";
            continue;
        }
        const std::string included = line.substr(directive.size(), line.rfind('"') - directive.size());
        if (std::find(source.files.begin(), source.files.end(), included) == source.files.end()) {
            splice(included, source);
        }
        begin_line(number + 1);
    }
}

}  // namespace

void set_shader_folder(const std::string& path) {
    shader_folder() = path;
}

ShaderSource shader_source(const std::string& name, const std::vector<std::string>& defines) {
    ShaderSource source;
    source.text = "#version 330 core\n#define BREWSTER_FUNCTION\n";
    for (const std::string& define : defines) source.text += "#define " + define + "\n";
    splice(name, source);
    return source;
}

}  // namespace brewster
