#include "scene/gltf_builder.h"

#include <cstring>

namespace brewster {
namespace {

template <class T>
std::string raw(const T& value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string base64(const std::string& bytes) {
    static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

GltfBuilder::GltfBuilder() {
    json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", nlohmann::json::array()}}}}};
}

int GltfBuilder::add_material(const std::string& name, std::array<double, 3> albedo, double emission) {
    nlohmann::json material = {
        {"name", name},
        {"pbrMetallicRoughness", {{"baseColorFactor", {albedo[0], albedo[1], albedo[2], 1}}, {"metallicFactor", 0}}},
        {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}};
    if (emission > 0) {
        material["emissiveFactor"] = {1, 1, 1};
        material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", emission}};
    }
    json["materials"].push_back(material);
    return static_cast<int>(json["materials"].size()) - 1;
}

int GltfBuilder::add_view(const std::string& bytes) {
    while (buffer_.size() % 4 != 0) buffer_ += '\0';
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_ += bytes;
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::add_mesh(const std::string& name, const std::vector<glm::vec3>& vertices, const Triangles& triangles,
                          int material, int component_type) {
    std::string positions, indices;
    if (component_type == 0) {
        for (const auto& triangle : triangles)
            for (const std::uint32_t vertex : triangle) positions += raw(vertices[vertex]);
    } else {
        for (const glm::vec3& p : vertices) positions += raw(p);
    }
    for (const auto& triangle : triangles)
        for (const std::uint32_t vertex : triangle)
            indices += component_type == 5121   ? raw(static_cast<std::uint8_t>(vertex))
                       : component_type == 5123 ? raw(static_cast<std::uint16_t>(vertex))
                                                : raw(vertex);
    nlohmann::json primitive = {{"attributes", {{"POSITION", json["accessors"].size()}}}};
    if (material >= 0) primitive["material"] = material;
    json["accessors"].push_back({{"bufferView", add_view(positions)},
                                 {"componentType", 5126},
                                 {"count", positions.size() / sizeof(glm::vec3)},
                                 {"type", "VEC3"}});
    if (component_type != 0) {
        primitive["indices"] = json["accessors"].size();
        json["accessors"].push_back({{"bufferView", add_view(indices)},
                                     {"componentType", component_type},
                                     {"count", 3 * triangles.size()},
                                     {"type", "SCALAR"}});
    }
    json["meshes"].push_back({{"name", name + " mesh"}, {"primitives", nlohmann::json::array({primitive})}});
    return add_node({{"name", name}, {"mesh", json["meshes"].size() - 1}});
}

int GltfBuilder::add_accessor(const std::string& bytes, const std::string& type, int component_type,
                              std::size_t count) {
    json["accessors"].push_back(
        {{"bufferView", add_view(bytes)}, {"componentType", component_type}, {"count", count}, {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

void GltfBuilder::add_attribute(int mesh, const std::string& name, const std::vector<glm::vec3>& values) {
    json["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0]["attributes"][name] =
        add_accessor(bytes_of(values), "VEC3", 5126, values.size());
}

int GltfBuilder::add_node(nlohmann::json node) {
    json["nodes"].push_back(std::move(node));
    const int index = static_cast<int>(json["nodes"].size()) - 1;
    json["scenes"][0]["nodes"].push_back(index);
    return index;
}

int GltfBuilder::add_polygon(const std::string& name, const std::vector<glm::vec3>& outline, int material) {
    Triangles fan;
    for (std::uint32_t k = 2; k < outline.size(); ++k) fan.push_back({0, k - 1, k});
    return add_mesh(name, outline, fan, material);
}

int GltfBuilder::add_box(const std::string& name, glm::vec3 low, glm::vec3 high, bool inward, int material) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    // Counter-clockwise seen from outside.
    Triangles triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 4, 6}, {0, 6, 2},
                           {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}};
    if (inward)
        for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
    return add_mesh(name, corners, triangles, material);
}

std::string GltfBuilder::text() const {
    nlohmann::json whole = json;
    if (!whole.contains("buffers"))
        whole["buffers"] = {
            {{"byteLength", buffer_.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer_)}}};
    return whole.dump();
}

std::string GltfBuilder::glb() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string text = whole.dump(), binary = buffer_;
    while (text.size() % 4 != 0) text += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    const auto word = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
    return "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" + text +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
}

}  // namespace brewster
