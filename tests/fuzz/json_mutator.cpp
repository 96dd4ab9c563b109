#include "fuzz/json_mutator.h"

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

namespace brewster {
namespace {

using nlohmann::json;
using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t count) {
    return random() % count;
}

/// A value and where it hangs.
struct Place {
    json* parent;
    std::string key;    // in an object
    std::size_t index;  // in a list
    json& value() const { return parent->is_object() ? (*parent)[key] : (*parent)[index]; }
};

void collect(json& value, std::vector<Place>& places) {
    constexpr std::size_t most = 4000;
    if (value.is_object())
        for (auto& [key, child] : value.items()) {
            if (places.size() < most) places.push_back({&value, key, 0});
            collect(child, places);
        }
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (places.size() < most) places.push_back({&value, "", i});
            collect(value[i], places);
        }
}

json any_number(Random& random) {
    static const std::array<json, 30> numbers = {
        0,    1,    2,    3,    4,    5,    6,    -1,  255,  256,  65535, 33071, 33648, 10497, 9728,
        5120, 5121, 5122, 5123, 5125, 5126, 1e-9, 0.5, -0.5, 1e-3, 100.0, 1e9,   1e-30, 1e30,  2147483647};
    return numbers[below(random, numbers.size())];
}

json any_text(Random& random) {
    static const std::array<const char*, 18> texts = {
        "MASK", "BLEND", "OPAQUE",      "VEC2",        "VEC3", "VEC4",    "SCALAR", "MAT4",
        "spot", "point", "directional", "perspective", "",     "a/b.bin", "data:,", "KHR_materials_unlit",
        "../x", "2.1"};
    return texts[below(random, texts.size())];
}

// Something that a file may hold, under its name.
void add_something(json& object, Random& random) {
    static const json things = json::parse(R"([
        {"doubleSided": true}, {"skin": 0}, {"byteStride": 16}, {"normalized": true}, {"mode": 5}, {"mode": 6},
        {"matrix": [1,0,0,0, 0,-1,0,0, 0,0,1,0, 3,0,0,1]}, {"rotation": [0.6,0,0.8,0]}, {"scale": [-1,1,2]},
        {"scale": [1,0,1]}, {"weights": [0.5]}, {"targets": [{"POSITION": 0}]}, {"camera": 0}, {"mesh": 0},
        {"alphaMode": "MASK"}, {"alphaCutoff": 0.3}, {"emissiveTexture": {"index": 0}}, {"normalTexture": {"index": 0}},
        {"NORMAL": 0}, {"NORMAL": 2}, {"TEXCOORD_0": 3}, {"COLOR_0": 4}, {"JOINTS_0": 5}, {"WEIGHTS_0": 4},
        {"sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5125}, "values": {"bufferView": 0}}},
        {"extensions": {"KHR_texture_transform": {"offset": [0.5, 1], "scale": [2, -3], "rotation": 1, "texCoord": 0}}},
        {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_volume":
            {"thicknessFactor": 1, "attenuationDistance": 1, "attenuationColor": [1, 0.5, 0]}}},
        {"extensions": {"KHR_materials_unlit": {}}}, {"extensions": {"KHR_materials_ior": {"ior": 1.33}}},
        {"extensions": {"KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 0]}}},
        {"extensions": {"BREWSTER_surface": {"polarizer": {"angle": 30}}}},
        {"extensions": {"BREWSTER_surface": {"retarder": {"angle": 45, "thickness": 10, "birefringence": 0.01}}}},
        {"extensions": {"BREWSTER_surface": {"rmsHeight": 0.2, "correlationLength": 2}}},
        {"extensions": {"BREWSTER_surface": {"complexIor": {"n": [0.2, 1, 2], "k": [3, 0, 1]}}}},
        {"extensions": {"BREWSTER_surface": {"polarization": {"dolp": 0.5, "aolp": 20, "docp": -0.5},
            "angularDiameter": 0.5}}}])");
    object.update(things[below(random, things.size())]);
}

void change(json& root, Random& random) {
    std::vector<Place> places;
    collect(root, places);
    if (places.empty()) return;
    const Place place = places[below(random, places.size())];
    json& value = place.value();
    switch (below(random, 8)) {
        case 0:
            value = json(places[below(random, places.size())].value());
            return;
        case 1:
            if (place.parent->is_object())
                place.parent->erase(place.key);
            else
                place.parent->erase(place.index);
            return;
        case 2:
            if (place.parent->is_array()) place.parent->push_back(json(value));
            return;
        case 3:
            if (value.is_object()) return add_something(value, random);
            break;
        default:
            break;
    }
    if (value.is_string())
        value = any_text(random);
    else if (value.is_number())
        value = any_number(random);
    else if (value.is_object())
        add_something(value, random);
    else if (value.is_boolean())
        value = !value.get<bool>();
}

std::string word(std::size_t number) {
    const auto low = static_cast<std::uint32_t>(number);
    return std::string(reinterpret_cast<const char*>(&low), 4);
}

}  // namespace

std::string with_changed_json(const std::string& file, std::uint32_t seed) {
    constexpr std::size_t header = 20;  // of the file and of its first chunk
    const bool binary = file.size() > header && file.compare(0, 4, "glTF") == 0;
    std::uint32_t length = static_cast<std::uint32_t>(file.size());
    if (binary) std::memcpy(&length, file.data() + 12, 4);
    if (binary && length > file.size() - header) return file;
    json root = json::parse(file.substr(binary ? header : 0, length), nullptr, false);
    if (root.is_discarded()) return file;
    Random random(seed | 1u);
    for (std::size_t n = 1 + below(random, 3); n > 0; --n) change(root, random);
    std::string text = root.dump(-1, ' ', false, json::error_handler_t::replace);
    if (!binary) return text;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string rest = file.substr(header + length);
    return file.substr(0, 8) + word(header + text.size() + rest.size()) + word(text.size()) + "JSON" + text + rest;
}

}  // namespace brewster
