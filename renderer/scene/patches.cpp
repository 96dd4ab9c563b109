#include "scene/patches.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "base/units.h"
#include "scene/disjoint_sets.h"
#include "scene/unfolded.h"

namespace brewster {
namespace {

// All normals lie within `angle` of the axis.
struct Cone {
    glm::dvec3 axis{0.0};
    double angle = 0;
};

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The narrowest cone around two.
Cone around(const Cone& a, const Cone& b) {
    const double between = angle_between(a.axis, b.axis);
    if (between + b.angle <= a.angle) return a;
    if (between + a.angle <= b.angle) return b;
    const double angle = 0.5 * (between + a.angle + b.angle), turn = angle - a.angle;
    const glm::dvec3 across = b.axis - glm::dot(a.axis, b.axis) * a.axis;
    const double length = glm::length(across);
    if (length < 1e-12) return {a.axis, angle};
    return {std::cos(turn) * a.axis + std::sin(turn) / length * across, angle};
}

// The side of a cube a normal looks at: its largest component, with its sign.
std::uint32_t side_of(glm::vec3 normal) {
    const glm::vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2u * static_cast<std::uint32_t>(axis) + (normal[axis] < 0 ? 1u : 0u);
}

glm::dvec3 axis_of_side(std::uint32_t side) {
    glm::dvec3 axis(0.0);
    axis[static_cast<int>(side / 2)] = side % 2 ? -1.0 : 1.0;
    return axis;
}

// Patches while they join; a patch goes by the name of its set.
class Patching {
  public:
    Patching(const std::vector<glm::vec3>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
             const std::vector<glm::vec3>& facet_normals, const std::vector<SmoothEdge>& edges)
        : vertices_(vertices), triangles_(triangles), normals_(facet_normals), sets_(triangles.size()) {
        DisjointSets surfaces(triangles.size());
        for (const SmoothEdge& edge : edges) surfaces.join(edge.first, edge.second);
        curved_.assign(triangles.size(), false);
        for (const SmoothEdge& edge : edges)
            if (edge.bends) curved_[surfaces.find(edge.first)] = true;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) curved_[t] = curved_[surfaces.find(t)];
        for (const SmoothEdge& edge : edges)
            if (curved_[edge.first]) edges_.push_back(edge);
        for (const SmoothEdge& edge : edges_)
            if (side_of(normals_[edge.first]) == side_of(normals_[edge.second])) sets_.join(edge.first, edge.second);
    }

    std::vector<Patch> run() {
        find_cones();
        while (join_some()) {
        }
        std::vector<Patch> patches;
        for (const auto& members : members_of_sets()) add_patches(members, patches);
        std::sort(patches.begin(), patches.end(),
                  [](const Patch& a, const Patch& b) { return a.triangles[0] < b.triangles[0]; });
        return patches;
    }

  private:
    double area(std::uint32_t t) const {
        const glm::dvec3 a(vertices_[triangles_[t][0]]);
        return 0.5 * glm::length(glm::cross(glm::dvec3(vertices_[triangles_[t][1]]) - a,
                                            glm::dvec3(vertices_[triangles_[t][2]]) - a));
    }

    // About the mean normal or the cube side's, whichever is narrower.
    void find_cones() {
        const std::size_t n = triangles_.size();
        cones_.resize(n);
        areas_.assign(n, 0);
        std::vector<glm::dvec3> sums(n, glm::dvec3(0));
        for (std::uint32_t t = 0; t < n; ++t) {
            if (!curved_[t]) continue;
            const std::uint32_t set = sets_.find(t);
            sums[set] += area(t) * glm::dvec3(normals_[t]);
            areas_[set] += area(t);
        }
        std::vector<double> about_side(n, 0);
        for (std::uint32_t t = 0; t < n; ++t)
            if (curved_[t] && sets_.find(t) == t) cones_[t].axis = glm::normalize(sums[t]);
        for (std::uint32_t t = 0; t < n; ++t) {
            if (!curved_[t]) continue;
            const std::uint32_t set = sets_.find(t);
            const glm::dvec3 normal(normals_[t]);
            cones_[set].angle = std::max(cones_[set].angle, angle_between(cones_[set].axis, normal));
            about_side[set] = std::max(about_side[set], angle_between(axis_of_side(side_of(normals_[t])), normal));
        }
        for (std::uint32_t t = 0; t < n; ++t)
            if (curved_[t] && sets_.find(t) == t && about_side[t] < cones_[t].angle)
                cones_[t] = {axis_of_side(side_of(normals_[t])), about_side[t]};
    }

    // Lets each patch, the smallest first, join the neighbour with the longest common border that its cone allows.
    bool join_some() {
        struct Border {
            std::uint32_t from, to;
            float length;
        };
        std::vector<Border> borders;
        for (const SmoothEdge& edge : edges_) {
            const std::uint32_t a = sets_.find(edge.first), b = sets_.find(edge.second);
            if (a == b) continue;
            borders.push_back({a, b, edge.length});
            borders.push_back({b, a, edge.length});
        }
        std::sort(borders.begin(), borders.end(), [this](const Border& a, const Border& b) {
            return std::tie(areas_[a.from], a.from, a.to) < std::tie(areas_[b.from], b.from, b.to);
        });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < borders.size(); ++i) {
            if (kept > 0 && borders[kept - 1].from == borders[i].from && borders[kept - 1].to == borders[i].to)
                borders[kept - 1].length += borders[i].length;
            else
                borders[kept++] = borders[i];
        }
        borders.resize(kept);
        bool any = false;
        for (std::size_t i = 0; i < borders.size();) {
            std::size_t end = i;
            float longest = 0;
            std::uint32_t best = borders[i].from;
            const std::uint32_t own = sets_.find(borders[i].from);
            for (; end < borders.size() && borders[end].from == borders[i].from; ++end) {
                const std::uint32_t other = sets_.find(borders[end].to);
                if (other == own || borders[end].length <= longest) continue;
                if (around(cones_[own], cones_[other]).angle > radians(widest_cone)) continue;
                longest = borders[end].length;
                best = other;
            }
            i = end;
            if (longest <= 0) continue;
            const Cone cone = around(cones_[own], cones_[best]);
            const double sum = areas_[own] + areas_[best];
            const std::uint32_t name = sets_.join(own, best);
            cones_[name] = cone;
            areas_[name] = sum;
            any = true;
        }
        return any;
    }

    std::vector<std::vector<std::uint32_t>> members_of_sets() {
        std::vector<std::vector<std::uint32_t>> members;
        std::vector<std::uint32_t> place(triangles_.size());
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            if (!curved_[t]) continue;
            const std::uint32_t set = sets_.find(t);
            if (set == t) {  // the smallest member comes first
                place[t] = static_cast<std::uint32_t>(members.size());
                members.emplace_back();
            }
            members[place[set]].push_back(t);
        }
        local_.resize(triangles_.size());
        inner_.resize(members.size());
        for (const auto& own : members)
            for (std::uint32_t i = 0; i < own.size(); ++i) local_[own[i]] = i;
        for (const SmoothEdge& edge : edges_) {
            const std::uint32_t set = sets_.find(edge.first);
            if (set == sets_.find(edge.second)) inner_[place[set]].push_back({local_[edge.first], local_[edge.second]});
        }
        next_ = 0;
        return members;
    }

    // One patch, or several if the projection would fold. Members come in the order of members_of_sets.
    void add_patches(const std::vector<std::uint32_t>& members, std::vector<Patch>& patches) {
        const glm::dvec3 axis = cones_[sets_.find(members[0])].axis;
        const glm::dvec3 lean = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 x = glm::normalize(glm::cross(lean, axis)), y = glm::cross(axis, x);
        std::vector<std::array<glm::dvec2, 3>> flat(members.size());
        for (std::size_t i = 0; i < members.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 p(vertices_[triangles_[members[i]][k]]);
                flat[i][k] = {glm::dot(p, x), glm::dot(p, y)};
            }
        const std::vector<std::uint32_t> layers = unfolded(flat, inner_[next_++]);
        const std::size_t first = patches.size();
        patches.resize(first + 1 + *std::max_element(layers.begin(), layers.end()));
        for (std::size_t i = 0; i < members.size(); ++i) patches[first + layers[i]].triangles.push_back(members[i]);
        for (std::size_t i = first; i < patches.size(); ++i) patches[i].axis = axis;
    }

    const std::vector<glm::vec3>& vertices_;
    const std::vector<std::array<std::uint32_t, 3>>& triangles_;
    const std::vector<glm::vec3>& normals_;
    DisjointSets sets_;
    std::vector<SmoothEdge> edges_;  // of curved surfaces
    std::vector<bool> curved_;       // per triangle
    std::vector<Cone> cones_;        // per set
    std::vector<double> areas_;      // per set
    std::vector<std::uint32_t> local_;
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> inner_;
    std::size_t next_ = 0;
};

}  // namespace

std::vector<Patch> curved_patches(const std::vector<glm::vec3>& vertices,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                  const std::vector<glm::vec3>& facet_normals, const std::vector<SmoothEdge>& edges) {
    if (std::none_of(edges.begin(), edges.end(), [](const SmoothEdge& edge) { return edge.bends; })) return {};
    return Patching(vertices, triangles, facet_normals, edges).run();
}

}  // namespace brewster
