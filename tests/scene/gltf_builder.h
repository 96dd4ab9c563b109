#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brewster {

/// Writes small glTF files for tests: one buffer as a data URI, one primitive a mesh, a node each.
/// The JSON is open to any change before `text`.
class GltfBuilder {
  public:
    GltfBuilder();

    using Triangles = std::vector<std::array<std::uint32_t, 3>>;

    /// Returns the material's index: Lambert without an interface.
    int add_material(const std::string& name, std::array<double, 3> albedo, double emission = 0);

    /// Adds mesh and node of that name; the node's index. `component_type`: of the indices; 0: no indices are written.
    int add_mesh(const std::string& name, const std::vector<glm::vec3>& vertices, const Triangles& triangles,
                 int material = 0, int component_type = 5125);

    int add_node(nlohmann::json node);

    /// Appends an accessor of these bytes to the file; its index.
    int add_accessor(const std::string& bytes, const std::string& type, int component_type, std::size_t count);

    /// Names an accessor of floats as an attribute of the mesh's first primitive.
    void add_attribute(int mesh, const std::string& name, const std::vector<glm::vec3>& values);

    /// A convex outline as a fan of triangles, counter-clockwise seen from the front.
    int add_polygon(const std::string& name, const std::vector<glm::vec3>& outline, int material = 0);

    /// An axis-aligned box of 12 triangles; `inward`: its front sides look in.
    int add_box(const std::string& name, glm::vec3 low, glm::vec3 high, bool inward, int material = 0);

    std::string text() const;  ///< with the buffer embedded
    std::string glb() const;   ///< the same as binary glTF

    nlohmann::json json;

    int add_view(const std::string& bytes);  ///< a bufferView of these bytes; its index

  private:
    std::string buffer_;
};

std::string base64(const std::string& bytes);

/// The numbers' bytes, one after another.
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
}

}  // namespace brewster
