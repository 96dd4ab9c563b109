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
constexpr double normal_cell = 2e-2;
constexpr double offset_cell = 5e-3;  // of the mesh's radius

struct Face {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 area_vector, normal, middle;
};

struct Growing {
    PlaneGroup group;
    glm::dvec3 low, high, area_vector{0.0};
    glm::dvec3 area_moment{0.0};
};

std::int64_t cell_of(double x, double width) {
    return static_cast<std::int64_t>(std::floor(x / width));
}

// Two cells may share a key: that only brings candidates that do not belong.
std::uint64_t key_of(const std::array<std::int64_t, 4>& cell) {
    std::uint64_t key = 0x9e3779b97f4a7c15u;
    for (const std::int64_t i : cell) {
        key = (key ^ static_cast<std::uint64_t>(i)) * 0xff51afd7ed558ccdu;
        key ^= key >> 32;
    }
    return key;
}

bool belongs(const Face& face, const Growing& plane, double distance_tolerance) {
    static const double least_cosine = std::cos(angle_tolerance);
    if (glm::dot(face.normal, plane.group.normal) < least_cosine) return false;
    glm::dvec3 low = plane.low, high = plane.high;
    double off = 0;
    for (const glm::dvec3& p : face.corners) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        off = std::max(off, std::abs(glm::dot(plane.group.normal, p) - plane.group.offset));
    }
    return off <= distance_tolerance * glm::length(high - low);
}

// The planes found so far, by cells of normal and offset. A plane stands in all cells that a face of it may fall in:
// the face's normal may be off by the angle tolerance, and its offset by as much times the radius.
class PlaneIndex {
  public:
    explicit PlaneIndex(double radius) : radius_(radius) {}

    // The first plane, in the order of adding, that `is_home` accepts for a face; none: -1.
    template <class IsHome>
    std::int64_t find(const Face& face, const IsHome& is_home) const {
        const auto chain = chains_.find(key_of(
            {cell_of(face.normal.x, normal_cell), cell_of(face.normal.y, normal_cell),
             cell_of(face.normal.z, normal_cell), cell_of(glm::dot(face.normal, face.middle), offset_cell * radius_)}));
        if (chain == chains_.end()) return -1;
        for (std::uint32_t link = chain->second.first; link != end; link = links_[link].next)
            if (is_home(links_[link].plane)) return links_[link].plane;
        return -1;
    }

    void add(std::uint32_t plane, glm::dvec3 normal, double offset) {
        std::array<std::int64_t, 4> low, high, cell;
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            low[axis] = cell_of(normal[k] - angle_tolerance, normal_cell);
            high[axis] = cell_of(normal[k] + angle_tolerance, normal_cell);
        }
        const double slack = (angle_tolerance + 1e-4) * radius_;
        low[3] = cell_of(offset - slack, offset_cell * radius_);
        high[3] = cell_of(offset + slack, offset_cell * radius_);
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
                    for (cell[3] = low[3]; cell[3] <= high[3]; ++cell[3]) append(key_of(cell), plane);
    }

  private:
    static constexpr std::uint32_t end = 0xffffffffu;
    struct Link {
        std::uint32_t plane, next;
    };
    struct Chain {
        std::uint32_t first, last;
    };

    void append(std::uint64_t key, std::uint32_t plane) {
        const auto link = static_cast<std::uint32_t>(links_.size());
        links_.push_back({plane, end});
        const auto [chain, is_new] = chains_.try_emplace(key, Chain{link, link});
        if (is_new) return;
        links_[chain->second.last].next = link;
        chain->second.last = link;
    }

    double radius_;
    std::vector<Link> links_;
    std::unordered_map<std::uint64_t, Chain> chains_;
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
        std::int64_t home =
            index.find(face, [&](std::uint32_t plane) { return belongs(face, planes[plane], distance_tolerance); });
        if (home < 0) {
            home = static_cast<std::int64_t>(planes.size());
            Growing plane;
            plane.group.normal = face.normal;
            plane.group.offset = glm::dot(face.normal, face.middle);
            plane.low = plane.high = face.middle;
            index.add(static_cast<std::uint32_t>(home), plane.group.normal, plane.group.offset);
            planes.push_back(std::move(plane));
        }
        add_face(planes[static_cast<std::size_t>(home)], face, i);
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
