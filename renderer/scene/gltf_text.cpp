#include "scene/gltf_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "scene/uri.h"

namespace brewster {
namespace {

using nlohmann::json;

constexpr int deepest = 64;
const char* const repair = "export the file again or mend it by hand";

enum class Kind { index, size, number, boolean, string, indices };

// Properties that are read, by name; the same name means the same wherever it is looked at.
const std::map<std::string, Kind> kinds = {
    {"accessor", Kind::index},
    {"alphaCutoff", Kind::number},
    {"alphaMode", Kind::string},
    {"aspectRatio", Kind::number},
    {"buffer", Kind::index},
    {"bufferView", Kind::index},
    {"byteLength", Kind::size},
    {"byteOffset", Kind::size},
    {"byteStride", Kind::size},
    {"camera", Kind::index},
    {"children", Kind::indices},
    {"componentType", Kind::index},
    {"count", Kind::size},
    {"doubleSided", Kind::boolean},
    {"emissiveStrength", Kind::number},
    {"index", Kind::index},
    {"innerConeAngle", Kind::number},
    {"intensity", Kind::number},
    {"ior", Kind::number},
    {"joints", Kind::indices},
    {"light", Kind::index},
    {"material", Kind::index},
    {"mesh", Kind::index},
    {"metallicFactor", Kind::number},
    {"mode", Kind::index},
    {"name", Kind::string},
    {"node", Kind::index},
    {"nodes", Kind::indices},
    {"outerConeAngle", Kind::number},
    {"range", Kind::number},
    {"sampler", Kind::index},
    {"skin", Kind::index},
    {"source", Kind::index},
    {"texCoord", Kind::index},
    {"specularFactor", Kind::number},
    {"roughnessFactor", Kind::number},
    {"uri", Kind::string},
    {"yfov", Kind::number},
    {"znear", Kind::number},
    {"minFilter", Kind::index},
    {"magFilter", Kind::index},
    {"wrapS", Kind::index},
    {"wrapT", Kind::index},
    {"inverseBindMatrices", Kind::index},
    {"skeleton", Kind::index},
    {"mimeType", Kind::string},
    {"version", Kind::string},
    {"minVersion", Kind::string},
    {"zfar", Kind::number},
    {"birefringence", Kind::number},
    {"thickness", Kind::number},
    {"retardance", Kind::number},
    {"angle", Kind::number},
    {"angularDiameter", Kind::number},
    {"docp", Kind::number},
    {"aolp", Kind::number},
    {"dolp", Kind::number},
    {"correlationLength", Kind::number},
    {"rmsHeight", Kind::number},
    {"attenuationDistance", Kind::number},
    {"thicknessFactor", Kind::number},
    {"transmissionFactor", Kind::number},
    {"normalized", Kind::boolean},
};

// Lists of numbers and their lengths.
const std::map<std::string, std::size_t> lengths = {
    {"baseColorFactor", 4},  {"emissiveFactor", 3},      {"color", 3}, {"matrix", 16},
    {"rotation", 4},         {"translation", 3},         {"n", 3},     {"k", 3},
    {"attenuationColor", 3}, {"specularColorFactor", 3},
};

const std::set<std::string> object_lists = {"accessors", "animations", "bufferViews", "buffers",  "cameras",
                                            "images",    "lights",     "materials",   "meshes",   "nodes",
                                            "samplers",  "scenes",     "skins",       "textures", "primitives"};

const std::set<std::string> read_extensions = {
    "KHR_lights_punctual",    "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_specular", "KHR_materials_transmission",      "KHR_materials_volume",
    "BREWSTER_surface"};

// Objects whose other kinds would read as if they were not there.
const std::set<std::string> objects = {"complexIor",
                                       "polarizer",
                                       "retarder",
                                       "polarization",
                                       "specularTexture",
                                       "transmissionTexture",
                                       "thicknessTexture",
                                       "specularColorTexture",
                                       "asset"};

class Checker {
  public:
    explicit Checker(const std::string& where) : where_(where) {}

    void check_root(const json& root) {
        if (!root.is_object()) wrong("the file", "is not a JSON object");
        for (const auto& [key, value] : root.items()) {
            if (key == "extras") continue;
            if (key == "scene") {
                check_kind(value, key, Kind::index);
            } else if (key == "nodes") {
                check_objects(value, key);
            } else if (key == "extensionsUsed" || key == "extensionsRequired") {
                check_names(value, key);
            } else {
                check_member(key, value, key);
            }
        }
        check_version(root);
        check_picture_views(root);
    }

  private:
    [[noreturn]] void wrong(const std::string& path, const std::string& fault) const {
        throw Error("\"" + path + "\" " + fault, where_, repair);
    }

    void check_member(const std::string& key, const json& value, const std::string& path) const {
        if (key == "extras") return;
        if (key == "extensions") {
            check_extensions(value, path);
        } else if (object_lists.count(key) != 0 && !(key == "nodes")) {
            check_objects(value, path);
        } else if (const auto kind = kinds.find(key); kind != kinds.end()) {
            check_kind(value, path, kind->second);
        } else if (const auto length = lengths.find(key); length != lengths.end()) {
            check_numbers(value, path, length->second);
        } else if (key == "scale" && path.rfind("nodes[", 0) == 0) {
            check_numbers(value, path, 3);  // a normal texture has a scale, too: one number
        } else if (key == "attributes") {
            check_attributes(value, path);
        } else if (key == "indices" && !value.is_object()) {
            check_kind(value, path, Kind::index);
        } else if (value.is_object()) {
            check_members(value, path);
        } else if (objects.count(key) != 0) {
            wrong(path, "is not an object");
        }
    }

    void check_members(const json& object, const std::string& path) const {
        for (const auto& [key, value] : object.items()) check_member(key, value, path + "." + key);
    }

    void check_objects(const json& list, const std::string& path) const {
        if (!list.is_array()) wrong(path, "is not a list");
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string here = path + "[" + std::to_string(i) + "]";
            if (!list[i].is_object()) wrong(here, "is not an object");
            check_members(list[i], here);
        }
    }

    void check_extensions(const json& object, const std::string& path) const {
        if (!object.is_object()) wrong(path, "is not an object");
        for (const auto& [key, value] : object.items()) {
            if (key == "KHR_texture_transform") check_texture_transform(value, path + "." + key);
            if (read_extensions.count(key) == 0) continue;
            if (!value.is_object()) wrong(path + "." + key, "is not an object");
            check_members(value, path + "." + key);
        }
    }

    // Its members share their names with those of nodes and buffers.
    void check_texture_transform(const json& object, const std::string& path) const {
        if (!object.is_object()) wrong(path, "is not an object");
        for (const auto& [key, value] : object.items()) {
            if (key == "offset" || key == "scale") check_numbers(value, path + "." + key, 2);
            if (key == "rotation") check_kind(value, path + "." + key, Kind::number);
            if (key == "texCoord") check_kind(value, path + "." + key, Kind::index);
        }
    }

    // Versions are "major.minor": any 2.x may be read as 2.0 unless it asks for more.
    void check_version(const json& root) const {
        if (!root.contains("asset") || !root["asset"].contains("version")) wrong("asset", "holds no version");
        const json& asset = root["asset"];
        const std::string version = asset["version"];
        const std::string least = asset.contains("minVersion") ? asset["minVersion"] : "2.0";
        if (version.rfind("2.", 0) != 0 || least != "2.0")
            throw Error("it is glTF " + (least != "2.0" ? least : version) + ", not 2.0", where_,
                        "export it as glTF 2.0");
    }

    void check_names(const json& list, const std::string& path) const {
        if (!list.is_array()) wrong(path, "is not a list");
        for (const json& name : list)
            if (!name.is_string()) wrong(path, "is not a list of names");
    }

    // The parser takes the address of an embedded picture's first byte before anyone could ask whether there is one.
    void check_picture_views(const json& root) const {
        if (!root.contains("images")) return;
        const auto size = [](const json& object, const char* name) -> std::uint64_t {
            return object.contains(name) ? object[name].get<std::uint64_t>() : 0;
        };
        const auto item = [&](const char* list, std::uint64_t i, const std::string& path) -> const json& {
            const std::size_t count = root.contains(list) ? root[list].size() : 0;
            if (i >= count)
                wrong(path, "is " + std::to_string(i) + ", but there are " + std::to_string(count) + " " + list);
            return root[list][i];
        };
        for (std::size_t i = 0; i < root["images"].size(); ++i) {
            const json& image = root["images"][i];
            if (!image.contains("bufferView")) continue;
            const std::string path = "images[" + std::to_string(i) + "].bufferView";
            const std::uint64_t index = size(image, "bufferView");
            const json& view = item("bufferViews", index, path);
            const json& buffer =
                item("buffers", size(view, "buffer"), "bufferViews[" + std::to_string(index) + "].buffer");
            const std::uint64_t length = size(view, "byteLength");
            if (length == 0 || size(view, "byteOffset") + length > size(buffer, "byteLength"))
                wrong("bufferViews[" + std::to_string(index) + "]",
                      "ends beyond its buffer of " + std::to_string(size(buffer, "byteLength")) + " bytes");
        }
    }

    void check_attributes(const json& object, const std::string& path) const {
        if (!object.is_object()) wrong(path, "is not an object");
        for (const auto& [key, value] : object.items()) check_kind(value, path + "." + key, Kind::index);
    }

    void check_numbers(const json& list, const std::string& path, std::size_t length) const {
        if (!list.is_array() || list.size() != length)
            wrong(path, "is not a list of " + std::to_string(length) + " numbers");
        for (const json& value : list) {
            if (!value.is_number()) wrong(path, "is not a list of " + std::to_string(length) + " numbers");
            check_width(value, path);
        }
    }

    // The parser keeps whole numbers of extensions in 32 bits, without a word.
    void check_width(const json& value, const std::string& path) const {
        if (value.is_number_integer() && std::abs(value.get<double>()) > std::numeric_limits<std::int32_t>::max())
            wrong(path, "is " + value.dump() + ", a whole number of more than 31 bits without a decimal point");
    }

    void check_kind(const json& value, const std::string& path, Kind kind) const {
        switch (kind) {
            case Kind::index:
                check_integer(value, path, std::numeric_limits<std::int32_t>::max());
                return;
            case Kind::size:
                check_integer(value, path, std::int64_t{1} << 48);
                return;
            case Kind::number:
                if (!value.is_number()) wrong(path, "is not a number");
                check_width(value, path);
                return;
            case Kind::boolean:
                if (!value.is_boolean()) wrong(path, "is neither true nor false");
                return;
            case Kind::string:
                if (!value.is_string()) wrong(path, "is not a string");
                if (path.size() > 4 && path.compare(path.size() - 4, 4, ".uri") == 0) check_uri(value);
                return;
            case Kind::indices:
                if (!value.is_array()) wrong(path, "is not a list");
                for (const json& index : value) check_kind(index, path, Kind::index);
                return;
        }
    }

    void check_uri(const std::string& uri) const {
        constexpr std::size_t longest_name = 200;
        if (!stays_below(uri))
            throw Error("it names \"" + uri.substr(0, longest_name) + "\", which is not below its own folder", where_,
                        "move that file beside it");
    }

    void check_integer(const json& value, const std::string& path, std::int64_t largest) const {
        if (!value.is_number_integer()) wrong(path, "is not an integer");
        if (value.is_number_unsigned()) {
            if (value.get<std::uint64_t>() > static_cast<std::uint64_t>(largest))
                wrong(path, "is " + value.dump() + ", too large");
        } else {
            wrong(path, "is " + value.dump() + ", below zero");
        }
    }

    const std::string& where_;
};

// Levels of lists and objects. The parser's own count would look at every list anew for each of its items.
int depth_of(std::string_view text) {
    int depth = 0, most = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '[' || c == '{') most = std::max(most, ++depth);
        if (c == ']' || c == '}') --depth;
    }
    return most;
}

}  // namespace

void check_gltf_text(std::string_view text, const std::string& where) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");  // spaces and a byte order mark
    if (first == std::string_view::npos) throw Error("it is empty", where, "choose a .gltf or .glb file");
    if (text[first] != '{' && text[first] != '[')
        throw Error("it is not a glTF file", where, "export the scene as glTF 2.0 (.glb or .gltf)");
    if (depth_of(text) > deepest) throw Error("its JSON is more than 64 levels deep", where, repair);
    json root;
    try {
        root = json::parse(text);
    } catch (const json::exception& fault) {
        throw Error(std::string("its JSON is broken (") + fault.what() + ")", where, repair);
    }
    Checker(where).check_root(root);
}

}  // namespace brewster
