#include "scene/read_mesh.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <string>
#include <unordered_map>

#include "scene/accessor.h"

namespace brewster {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;
constexpr float flat_within = 1e-3f;  // sine: normals this close to their facet's come from rounding, not from a curve

const GltfAccessor& accessor(const GltfFile& file, int index) {
    return file.accessors[static_cast<std::size_t>(index)];
}

const GltfAccessor& positions_of(const GltfFile& file, const GltfPrimitive& primitive) {
    return accessor(file, primitive.attributes.at("POSITION"));
}

std::size_t corner_count(const GltfFile& file, const GltfPrimitive& primitive) {
    return primitive.indices < 0 ? positions_of(file, primitive).count : accessor(file, primitive.indices).count;
}

// The inverse transpose but for a positive factor: its columns are cross products, so it exists for flat nodes, too.
glm::dmat3 normal_transform(const glm::dmat3& m) {
    const double sign = glm::determinant(m) < 0 ? -1.0 : 1.0;
    return {sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])};
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

// Twice the area long.
glm::dvec3 facet_normal(const PlacedPrimitive& part, const std::array<std::uint32_t, 3>& t) {
    return glm::cross(part.vertices[t[1]] - part.vertices[t[0]], part.vertices[t[2]] - part.vertices[t[0]]);
}

void mend_normals(PlacedPrimitive& part) {
    std::vector<glm::dvec3> means(part.vertices.size(), glm::dvec3(0.0));
    for (const auto& triangle : part.triangles)
        for (const std::uint32_t vertex : triangle) means[vertex] += facet_normal(part, triangle);
    for (std::size_t i = 0; i < part.normals.size(); ++i) {
        if (part.normals[i] != glm::vec3(0.0f)) continue;
        part.normals[i] = unit_or_zero(means[i]);
        // Facets that cancel, or none with an area: any direction is as good.
        if (part.normals[i] == glm::vec3(0.0f)) part.normals[i] = glm::vec3(0, 1, 0);
        ++part.mended_normals;
    }
}

bool is_flat(const PlacedPrimitive& part) {
    for (const auto& triangle : part.triangles) {
        const glm::vec3 facet = unit_or_zero(facet_normal(part, triangle));
        if (facet == glm::vec3(0.0f)) continue;
        for (const std::uint32_t vertex : triangle) {
            const glm::vec3 n = part.normals[vertex];
            if (glm::length(glm::cross(facet, n)) > flat_within || glm::dot(facet, n) < 0) return false;
        }
    }
    return true;
}

const GltfAccessor* attribute(const GltfFile& file, const GltfPrimitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? nullptr : &accessor(file, found->second);
}

// Integers are fractions here, whether the file says so or not.
glm::vec4 read_color(const GltfFile& file, GltfAccessor colors, std::size_t i) {
    colors.normalized = true;
    glm::vec4 color = read_vector(file, colors, i);
    if (colors.components == 3) color.w = 1.0f;
    return glm::clamp(color, 0.0f, 1.0f);
}

// Which of a primitive's vertices are placed already, and as what. Many primitives may each use a few of many vertices.
class PlacedNumbers {
  public:
    PlacedNumbers(std::size_t vertices, std::size_t corners) : few_(corners < vertices / 8) {
        if (!few_) numbers_.assign(vertices, unused);
    }
    std::uint32_t& of(std::uint32_t vertex) {
        return few_ ? map_.try_emplace(vertex, unused).first->second : numbers_[vertex];
    }

  private:
    bool few_;
    std::vector<std::uint32_t> numbers_;
    std::unordered_map<std::uint32_t, std::uint32_t> map_;
};

// Where each vertex of a primitive goes.
class Pose {
  public:
    Pose(const GltfFile& file, const GltfPrimitive& primitive, const MeshPlace& place) : file_(file), place_(place) {
        for (int set = 0; !place.joints.empty(); ++set) {
            const GltfAccessor* joints = attribute(file, primitive, "JOINTS_" + std::to_string(set));
            const GltfAccessor* weights = attribute(file, primitive, "WEIGHTS_" + std::to_string(set));
            if (!joints || !weights) break;
            sets_.push_back({joints, *weights});
            sets_.back().weights.normalized = true;
        }
    }

    glm::dmat4 of_vertex(std::size_t i) const {
        glm::dmat4 sum(0.0);
        double whole = 0;
        for (const Set& set : sets_) {
            const glm::vec4 joint = read_vector(file_, *set.joints, i), weight = read_vector(file_, set.weights, i);
            for (int k = 0; k < 4; ++k) {
                if (!(weight[k] > 0)) continue;
                sum += static_cast<double>(weight[k]) * place_.joints[static_cast<std::size_t>(joint[k])];
                whole += static_cast<double>(weight[k]);
            }
        }
        return whole > 0 ? sum / whole : place_.to_world;
    }

  private:
    struct Set {
        const GltfAccessor* joints;
        GltfAccessor weights;
    };
    const GltfFile& file_;
    const MeshPlace& place_;
    std::vector<Set> sets_;
};

}  // namespace

std::size_t triangle_count(const GltfFile& file, const GltfPrimitive& primitive) {
    if (primitive.mode < gltf_triangles) return 0;
    const std::size_t corners = corner_count(file, primitive);
    if (primitive.mode == gltf_triangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
}

std::array<std::size_t, 3> triangle_corners(int mode, std::size_t t) {
    switch (mode) {
        case gltf_triangle_strip:
            return {t, t + 1 + t % 2, t + 2 - t % 2};
        case gltf_triangle_fan:
            return {t + 1, t + 2, 0};
        default:
            return {3 * t, 3 * t + 1, 3 * t + 2};
    }
}

PlacedPrimitive place_primitive(const GltfFile& file, const GltfPrimitive& primitive, const MeshPlace& place,
                                int texture_set) {
    const GltfAccessor& positions = positions_of(file, primitive);
    const GltfAccessor* normals = attribute(file, primitive, "NORMAL");
    const GltfAccessor* coordinates = attribute(file, primitive, "TEXCOORD_" + std::to_string(texture_set));
    const GltfAccessor* colors = attribute(file, primitive, "COLOR_0");
    const Pose pose(file, primitive, place);

    PlacedPrimitive part;
    PlacedNumbers placed(positions.count, corner_count(file, primitive));
    std::vector<bool> mirrored;
    bool mend = false;
    const auto vertex = [&](std::size_t corner) {
        const std::uint32_t i = primitive.indices < 0 ? static_cast<std::uint32_t>(corner)
                                                      : read_index(file, accessor(file, primitive.indices), corner);
        std::uint32_t& number = placed.of(i);
        if (number != unused) return number;
        number = static_cast<std::uint32_t>(part.vertices.size());
        const glm::dmat4 to_world = pose.of_vertex(i);
        mirrored.push_back(glm::determinant(glm::dmat3(to_world)) < 0);
        part.vertices.emplace_back(to_world * glm::dvec4(glm::dvec3(read_vector(file, positions, i)), 1.0));
        if (normals) {
            const glm::dmat3 turned = normal_transform(glm::dmat3(to_world));
            part.normals.push_back(unit_or_zero(turned * glm::dvec3(read_vector(file, *normals, i))));
            mend = mend || part.normals.back() == glm::vec3(0.0f);
        }
        if (coordinates) part.texture_coordinates.emplace_back(read_vector(file, *coordinates, i));
        if (colors) part.colors.push_back(read_color(file, *colors, i));
        return number;
    };
    const std::size_t count = triangle_count(file, primitive);
    for (std::size_t t = 0; t < count; ++t) {
        const std::array<std::size_t, 3> corners = triangle_corners(primitive.mode, t);
        std::array<std::uint32_t, 3> triangle = {vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
        if (mirrored[triangle[0]]) std::swap(triangle[1], triangle[2]);
        part.triangles.push_back(triangle);
    }
    if (mend) mend_normals(part);
    if (normals && is_flat(part)) part.normals.clear();
    return part;
}

}  // namespace brewster
