#include "app/view_text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/analyzer_text.h"
#include "app/suggestion.h"
#include "base/error.h"
#include "base/units.h"

namespace brewster {
namespace {

struct ViewWord {
    std::string key, value;
};

[[noreturn]] void refuse(const ViewWord& word, const std::string& wish) {
    throw Error("'" + word.value + "' is not " + wish, "view, word " + word.key, "mend the word or leave it out");
}

/// The words of the text: key=value, the value up to the next space or between double quotes.
std::vector<ViewWord> words_of(std::string_view text) {
    std::vector<ViewWord> words;
    std::size_t at = 0;
    while ((at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos) {
        const std::size_t equals = text.find_first_of("= \t\r\n", at);
        if (equals == std::string_view::npos || text[equals] != '=')
            throw Error("'" + std::string(text.substr(at, equals - at)) + "' is no word like key=value", "view",
                        "write for example camera=front map=dolp");
        ViewWord word{std::string(text.substr(at, equals - at)), {}};
        at = equals + 1;
        const bool quoted = at < text.size() && text[at] == '"';
        if (quoted) ++at;
        const std::size_t end = quoted ? text.find('"', at) : text.find_first_of(" \t\r\n", at);
        if (quoted && end == std::string_view::npos)
            throw Error("a quote is not closed", "view, word " + word.key, "end the value with \"");
        word.value = text.substr(at, end - at);
        at = end == std::string_view::npos ? text.size() : end + (quoted ? 1 : 0);
        words.push_back(std::move(word));
    }
    return words;
}

double number(const ViewWord& word, double least, double most) {
    const std::optional<double> value = parse_number(word.value);
    if (!value || *value < least || *value > most)
        refuse(word, "a number from " + significant(least) + " to " + significant(most));
    return *value;
}

std::uint64_t whole_number(const ViewWord& word, std::uint64_t least, std::uint64_t most) {
    const std::optional<std::uint64_t> value = parse_whole_number(word.value);
    if (!value || *value < least || *value > most)
        refuse(word, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return *value;
}

bool on_or_off(const ViewWord& word) {
    if (word.value != "on" && word.value != "off") refuse(word, "on or off");
    return word.value == "on";
}

glm::dvec3 point(const ViewWord& word) {
    glm::dvec3 place(0.0);
    std::string_view rest = word.value;
    for (int k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? rest.find(',') : rest.size();
        const std::optional<double> value =
            comma == std::string_view::npos ? std::nullopt : parse_number(rest.substr(0, comma));
        constexpr double far = 1e12;  // pictures hold single precision, squared distances too
        if (!value || !(std::abs(*value) <= far)) refuse(word, "three numbers like 1,0.5,-2, none beyond 1e12");
        place[k] = *value;
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return place;
}

template <class Value>
Value known(const ViewWord& word, const std::optional<Value>& value, const std::string& wish) {
    if (!value) refuse(word, wish);
    return *value;
}

View::Pose& pose_in(View& view) {
    if (!view.pose) view.pose = View::Pose{};  // clang 14 does not see that emplace() would do
    return *view.pose;
}

void take(const ViewWord& word, View& view) {
    static const std::vector<std::string> keys = {"camera",       "eye",    "target",  "up",      "fov",
                                                  "size",         "ev",     "map",     "palette", "analyzer",
                                                  "polarization", "gather", "samples", "seed"};
    const std::string& key = word.key;
    if (key == "camera") {
        view.camera = word.value;
    } else if (key == "eye") {
        pose_in(view).eye = point(word);
    } else if (key == "target") {
        pose_in(view).target = point(word);
    } else if (key == "up") {
        pose_in(view).up = point(word);
    } else if (key == "fov") {
        pose_in(view).field_of_view = number(word, 0.01, 179);
    } else if (key == "size") {
        view.size = known(word, parse_size(word.value), "a size like 640x480");
    } else if (key == "ev") {
        view.exposure = number(word, -64, 64);
    } else if (key == "map") {
        view.map = known(word, find_map(word.value), "a map");
    } else if (key == "palette") {
        view.palette = known(word, find_palette(word.value), "a palette");
    } else if (key == "analyzer") {
        view.analyzer = known(word, parse_analyzer(word.value), "an angle in degrees, right, left or none");
    } else if (key == "polarization") {
        view.polarization = on_or_off(word);
    } else if (key == "gather") {
        view.gather = on_or_off(word);
    } else if (key == "samples") {
        view.samples = static_cast<int>(whole_number(word, 1, 1 << 20));
    } else if (key == "seed") {
        view.seed = whole_number(word, 0, std::numeric_limits<std::uint64_t>::max());
    } else {
        throw Error("there is no word '" + key + "'" + did_you_mean(key, keys), "view", "see brewster shot --help");
    }
}

std::string point_text(const glm::dvec3& place) {
    return exact_text(place.x) + "," + exact_text(place.y) + "," + exact_text(place.z);
}

std::string quoted(const std::string& value) {
    if (!value.empty() && value.find_first_of(" \t") == std::string::npos && value.front() != '"') return value;
    return '"' + value + '"';
}

}  // namespace

View parse_view(std::string_view text) {
    View view;
    bool has_eye = false, has_target = false;
    for (const ViewWord& word : words_of(text)) {
        take(word, view);
        has_eye = has_eye || word.key == "eye";
        has_target = has_target || word.key == "target";
    }
    if (view.pose && !(has_eye && has_target))
        throw Error("a pose needs eye and target", "view", "give both, or a camera of the scene alone");
    return view;
}

std::vector<View> read_views(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw Error("cannot be read", path, "give a file with one view a line");
    std::vector<View> views;
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first != std::string::npos && line[first] != '#') views.push_back(parse_view(line));
    }
    return views;
}

std::string view_text(const View& view) {
    std::string text;
    const auto add = [&](const char* key, const std::string& value) {
        text += (text.empty() ? "" : " ") + std::string(key) + "=" + value;
    };
    if (!view.camera.empty()) add("camera", quoted(view.camera));
    if (view.pose) {
        add("eye", point_text(view.pose->eye));
        add("target", point_text(view.pose->target));
        add("up", point_text(view.pose->up));
        add("fov", exact_text(view.pose->field_of_view));
    }
    if (view.size) add("size", std::to_string(view.size->width) + "x" + std::to_string(view.size->height));
    if (view.exposure) add("ev", exact_text(*view.exposure));
    if (view.map) add("map", std::string(description(*view.map).name));
    if (view.palette) add("palette", std::string(palette_name(*view.palette)));
    if (view.analyzer) add("analyzer", analyzer_text(*view.analyzer));
    if (view.polarization) add("polarization", *view.polarization ? "on" : "off");
    if (view.gather) add("gather", *view.gather ? "on" : "off");
    if (view.samples) add("samples", std::to_string(*view.samples));
    if (view.seed) add("seed", std::to_string(*view.seed));
    return text;
}

View::Pose pose_of(const Scene& scene, const Camera& camera) {
    const glm::dvec3 eye = glm::dvec3(camera.position) + scene.centre;
    return {eye, eye + glm::dvec3(camera.forward), glm::dvec3(camera.up),
            degrees(static_cast<double>(camera.vertical_field_of_view))};
}

Camera camera_of(const Scene& scene, const View& view) {
    if (!view.pose) return scene.camera(view.camera);
    const View::Pose& pose = *view.pose;
    const glm::dvec3 sight = pose.target - pose.eye, right = glm::cross(sight, pose.up);
    if (!(glm::length(right) > 1e-9 * glm::length(sight) * glm::length(pose.up)))
        throw Error("it looks nowhere: target on eye, or up along the sight", "view", "move target or up");
    Camera camera;
    camera.name = view.camera.empty() ? "view" : view.camera;
    camera.position = glm::vec3(pose.eye - scene.centre);
    camera.forward = glm::vec3(glm::normalize(sight));
    camera.up = glm::vec3(glm::normalize(glm::cross(right, sight)));
    camera.vertical_field_of_view = static_cast<float>(radians(pose.field_of_view));
    if (view.size) camera.aspect_ratio = static_cast<float>(view.size->width) / static_cast<float>(view.size->height);
    for (const Camera& known : scene.cameras)
        if (known.name == view.camera) camera.near_distance = known.near_distance;
    return camera;
}

void apply_view(const View& view, ShotOptions& options) {
    if (!view.camera.empty() || view.pose) options.views.push_back(view);
    if (view.size) options.size = view.size;
    if (view.exposure) options.exposure = view.exposure;
    if (view.map) options.maps = {*view.map};
    if (view.palette) options.palette = *view.palette;
    if (view.analyzer) options.analyzer = *view.analyzer;
    if (view.polarization) options.polarization = *view.polarization;
    if (view.gather) options.gather = *view.gather;
    if (view.samples) options.samples = *view.samples;
    if (view.seed) options.solve.engine.seed = *view.seed;
}

void add_views(Scene& scene, ShotOptions& options) {
    for (const View& view : options.views) {
        Camera camera = camera_of(scene, view);
        if (view.pose) {
            const auto known = [&](const Camera& other) { return other.name == camera.name; };
            while (std::any_of(scene.cameras.begin(), scene.cameras.end(), known)) camera.name += " (moved)";
            scene.cameras.push_back(camera);
        }
        options.cameras.push_back(camera.name);
    }
}

}  // namespace brewster
