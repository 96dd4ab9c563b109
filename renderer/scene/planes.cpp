#include "scene/planes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <unordered_map>

#include "base/units.h"

namespace brewster {
namespace {

constexpr double angle_tolerance = radians(0.1);
constexpr double normal_cell = 4e-3;  // more than twice the angle, so that a normal is near two cells an axis at most
constexpr double offset_cell = 1e-2;  // of the mesh's radius; wider than what two normals of one cell make of an offset

struct Face {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 area_vector, normal, middle;
};

struct Growing {
    PlaneGroup group;
    glm::dvec3 low, high, area_vector{0.0};
    glm::dvec3 area_moment{0.0};
};

struct Cell {
    std::array<std::int64_t, 4> index;
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15u;
        for (const std::int64_t i : cell.index) {
            hash = (hash ^ static_cast<std::uint64_t>(i)) * 0xff51afd7ed558ccdu;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

std::int64_t cell_of(double x, double width) {
    return static_cast<std::int64_t>(std::floor(x / width));
}

// The direction along which offsets are measured in a cell of normals: the same for every plane in it.
glm::dvec3 cell_direction(const std::array<std::int64_t, 3>& cell) {
    return glm::normalize(
        (glm::dvec3(static_cast<double>(cell[0]), static_cast<double>(cell[1]), static_cast<double>(cell[2])) + 0.5) *
        normal_cell);
}

bool belongs(const Face& face, const Growing& plane, double distance_tolerance) {
    if (glm::dot(face.normal, plane.group.normal) < std::cos(angle_tolerance)) return false;
    glm::dvec3 low = plane.low, high = plane.high;
    double off = 0;
    for (const glm::dvec3& p : face.corners) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        off = std::max(off, std::abs(glm::dot(plane.group.normal, p) - plane.group.offset));
    }
    return off <= distance_tolerance * glm::length(high - low);
}

// The planes found so far, by cells of normal and offset.
class PlaneIndex {
  public:
    explicit PlaneIndex(double radius) : radius_(radius) {}

    const std::vector<std::uint32_t>* candidates(const Face& face) const {
        const std::array<std::int64_t, 3> cell = {cell_of(face.normal.x, normal_cell),
                                                  cell_of(face.normal.y, normal_cell),
                                                  cell_of(face.normal.z, normal_cell)};
        const double offset = glm::dot(cell_direction(cell), face.middle);
        const auto found = cells_.find({{cell[0], cell[1], cell[2], cell_of(offset, offset_cell * radius_)}});
        return found == cells_.end() ? nullptr : &found->second;
    }

    void add(std::uint32_t plane, glm::dvec3 normal, double offset) {
        std::array<std::int64_t, 3> low, high, cell;
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            low[axis] = cell_of(normal[k] - angle_tolerance, normal_cell);
            high[axis] = cell_of(normal[k] + angle_tolerance, normal_cell);
        }
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) add_to(cell, plane, normal, offset);
    }

  private:
    // Within the mesh's radius, the plane's points lie this far apart along the cell's direction.
    void add_to(const std::array<std::int64_t, 3>& cell, std::uint32_t plane, glm::dvec3 normal, double offset) {
        const double spread = glm::length(cell_direction(cell) - normal) * radius_;
        const std::int64_t first = cell_of(offset - spread, offset_cell * radius_);
        const std::int64_t last = cell_of(offset + spread, offset_cell * radius_);
        for (std::int64_t i = first; i <= last; ++i) cells_[{{cell[0], cell[1], cell[2], i}}].push_back(plane);
    }

    double radius_;
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

std::vector<Face> faces_of(const std::vector<glm::vec3>& vertices,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles, glm::dvec3 centre) {
    std::vector<Face> faces;
    faces.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
        Face face;
        face.corners = {glm::dvec3(vertices[a]) - centre, glm::dvec3(vertices[b]) - centre,
                        glm::dvec3(vertices[c]) - centre};
        face.area_vector = 0.5 * glm::cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]);
        face.normal = glm::normalize(face.area_vector);
        face.middle = (face.corners[0] + face.corners[1] + face.corners[2]) / 3.0;
        faces.push_back(face);
    }
    return faces;
}

void add_face(Growing& plane, const Face& face, std::uint32_t index) {
    plane.group.triangles.push_back(index);
    for (const glm::dvec3& p : face.corners) {
        plane.low = glm::min(plane.low, p);
        plane.high = glm::max(plane.high, p);
    }
    plane.area_vector += face.area_vector;
    plane.area_moment += glm::length(face.area_vector) * face.middle;
}

}  // namespace

std::vector<PlaneGroup> plane_groups(const std::vector<glm::vec3>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                     double distance_tolerance) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const auto& triangle : triangles)
        for (const std::uint32_t vertex : triangle) {
            low = glm::min(low, glm::dvec3(vertices[vertex]));
            high = glm::max(high, glm::dvec3(vertices[vertex]));
        }
    const glm::dvec3 centre = 0.5 * (low + high);
    const std::vector<Face> faces = faces_of(vertices, triangles, centre);

    // Large triangles first: their normals are the most exact, so they found the planes.
    std::vector<std::uint32_t> order(faces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&faces](std::uint32_t a, std::uint32_t b) {
        return glm::dot(faces[a].area_vector, faces[a].area_vector) >
               glm::dot(faces[b].area_vector, faces[b].area_vector);
    });

    PlaneIndex index(0.5 * glm::length(high - low));
    std::vector<Growing> planes;
    for (const std::uint32_t i : order) {
        const Face& face = faces[i];
        const std::vector<std::uint32_t>* candidates = index.candidates(face);
        Growing* home = nullptr;
        for (std::size_t k = 0; candidates && k < candidates->size() && !home; ++k)
            if (belongs(face, planes[(*candidates)[k]], distance_tolerance)) home = &planes[(*candidates)[k]];
        if (!home) {
            Growing plane;
            plane.group.normal = face.normal;
            plane.group.offset = glm::dot(face.normal, face.middle);
            plane.low = plane.high = face.middle;
            index.add(static_cast<std::uint32_t>(planes.size()), plane.group.normal, plane.group.offset);
            planes.push_back(plane);
            home = &planes.back();
        }
        add_face(*home, face, i);
    }

    std::vector<PlaneGroup> groups;
    groups.reserve(planes.size());
    for (Growing& plane : planes) {
        PlaneGroup& group = plane.group;
        std::sort(group.triangles.begin(), group.triangles.end());
        double area = 0;
        for (const std::uint32_t i : group.triangles) area += glm::length(faces[i].area_vector);
        group.normal = glm::normalize(plane.area_vector);
        group.offset = glm::dot(group.normal, plane.area_moment / area + centre);
        groups.push_back(std::move(group));
    }
    std::sort(groups.begin(), groups.end(),
              [](const PlaneGroup& a, const PlaneGroup& b) { return a.triangles[0] < b.triangles[0]; });
    return groups;
}

}  // namespace brewster
