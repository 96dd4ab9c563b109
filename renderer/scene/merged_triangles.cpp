#include "scene/merged_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "scene/disjoint_sets.h"

namespace brewster {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Ring = std::vector<std::uint32_t>;  // vertices, counter-clockwise

constexpr std::size_t most_corners = 64;
constexpr double same_area = 1e-6;  // relative
// Below this height, relative to the longest edge, a new triangle would be too thin to meet.
constexpr double thinnest = 1e-4;
// How far what vertices carry may be from linear: rounding of files, where colours have eight bits.
constexpr float same_normal = 1e-4f, same_coordinate = 1e-5f, same_color = 1.0f / 512;

// A plane's vertices in coordinates of its own; those at one place are one.
class FlatPoints {
  public:
    FlatPoints(const std::vector<glm::vec3>& vertices, const glm::dvec3& normal) : vertices_(vertices) {
        const glm::dvec3 lean = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        x_ = glm::normalize(lean - glm::dot(lean, normal) * normal);
        y_ = glm::cross(normal, x_);
    }

    glm::dvec2 operator[](std::uint32_t vertex) const {
        const glm::dvec3 p(vertices_[vertex]);
        return {glm::dot(p, x_), glm::dot(p, y_)};
    }

    // The first vertex that was asked for at the same place.
    std::uint32_t welded(std::uint32_t vertex) {
        return first_at_.try_emplace(vertices_[vertex] + glm::vec3(0.0f), vertex).first->second;  // -0 is 0
    }

  private:
    struct Hash {
        std::size_t operator()(const glm::vec3& p) const {
            std::size_t key = 0;
            for (int k = 0; k < 3; ++k) key = key * 0x9e3779b97f4a7c15u + std::hash<float>()(p[k]);
            return key ^ key >> 29;
        }
    };
    const std::vector<glm::vec3>& vertices_;
    glm::dvec3 x_, y_;
    std::unordered_map<glm::vec3, std::uint32_t, Hash> first_at_;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Twice its area; negative: clockwise.
double doubled_area(const FlatPoints& points, const Corners& t) {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

glm::dvec3 barycentric(const FlatPoints& points, const Corners& t, const glm::dvec2& p) {
    const glm::dvec2 a = points[t[0]], b = points[t[1]], c = points[t[2]];
    return glm::dvec3(cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p)) / doubled_area(points, t);
}

std::uint64_t edge(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32 | to;
}

// The edges of a plane, each with its triangle, and the pieces that they join.
struct Net {
    std::vector<Corners> welded;
    std::unordered_map<std::uint64_t, std::uint32_t> edges;
    std::vector<std::vector<std::uint32_t>> pieces;  // triangles
    bool overlaps = false;                           // two triangles lie on the same side of an edge
};

Net net_of(FlatPoints& points, const std::vector<Corners>& members) {
    Net net;
    for (const Corners& t : members)
        net.welded.push_back({points.welded(t[0]), points.welded(t[1]), points.welded(t[2])});
    for (std::uint32_t i = 0; i < net.welded.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (!net.edges.try_emplace(edge(net.welded[i][k], net.welded[i][(k + 1) % 3]), i).second)
                net.overlaps = true;
    DisjointSets sets(net.welded.size());
    for (std::uint32_t i = 0; i < net.welded.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto other = net.edges.find(edge(net.welded[i][(k + 1) % 3], net.welded[i][k]));
                other != net.edges.end())
                sets.join(i, other->second);
    std::vector<std::size_t> piece_of(net.welded.size());  // a set is named by its first triangle
    for (std::uint32_t i = 0; i < net.welded.size(); ++i) {
        const std::uint32_t name = sets.find(i);
        if (name == i) {
            piece_of[i] = net.pieces.size();
            net.pieces.emplace_back();
        }
        net.pieces[piece_of[name]].push_back(i);
    }
    return net;
}

// The rings around a piece, holes clockwise; none if two meet in a corner.
std::vector<Ring> rings_of(const Net& net, const std::vector<std::uint32_t>& piece) {
    std::unordered_map<std::uint32_t, std::uint32_t> next;
    std::vector<std::uint32_t> starts;
    for (const std::uint32_t i : piece)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = net.welded[i][k], to = net.welded[i][(k + 1) % 3];
            if (net.edges.count(edge(to, from)) != 0) continue;
            if (!next.try_emplace(from, to).second) return {};
            starts.push_back(from);
        }
    std::vector<Ring> rings;
    for (const std::uint32_t start : starts) {
        Ring ring;
        for (auto at = next.find(start); at != next.end(); at = next.find(ring.back())) {
            ring.push_back(at->second);
            next.erase(at);
        }
        if (!ring.empty()) rings.push_back(std::move(ring));
    }
    return rings;
}

double distance_to_line(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(cross(b - a, p - a)) / glm::length(b - a);
}

// Without the vertices on straight edges. Empty if an edge only seems straight from each to the next.
Ring corners_of(const FlatPoints& points, const Ring& outline, double tolerance) {
    const std::size_t count = outline.size();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 p = points[outline[i]], before = points[outline[(i + count - 1) % count]],
                         after = points[outline[(i + 1) % count]];
        if (glm::dot(p - before, after - p) <= 0 || distance_to_line(p, before, after) > tolerance) kept.push_back(i);
    }
    Ring corners;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const std::size_t begin = kept[k], end = k + 1 < kept.size() ? kept[k + 1] : kept[0] + count;
        corners.push_back(outline[begin]);
        for (std::size_t i = begin + 1; i < end; ++i)
            if (distance_to_line(points[outline[i % count]], points[outline[begin]], points[outline[end % count]]) >
                tolerance)
                return {};
    }
    return corners;
}

double doubled_area(const FlatPoints& points, const Ring& ring) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        area += doubled_area(points, Corners{ring[0], ring[i], ring[i + 1]});
    return area;
}

// Whether the way between two vertices touches an edge of the ring that does not end in one of them.
bool is_crossed(const FlatPoints& points, const Ring& ring, std::uint32_t from, std::uint32_t to) {
    const glm::dvec2 a = points[from], b = points[to];
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t begin = ring[i], end = ring[(i + 1) % ring.size()];
        if (begin == from || begin == to || end == from || end == to) continue;
        const glm::dvec2 c = points[begin], d = points[end];
        if (cross(b - a, c - a) * cross(b - a, d - a) <= 0 && cross(d - c, a - c) * cross(d - c, b - c) <= 0)
            return true;
    }
    return false;
}

// One ring that goes around the outline and, by a cut there and back, around every hole. Empty where a hole cannot be
// reached.
Ring joined_rings(const FlatPoints& points, std::vector<Ring> rings) {
    std::stable_partition(rings.begin(), rings.end(), [&](const Ring& ring) { return doubled_area(points, ring) > 0; });
    while (rings.size() > 1) {
        double shortest = INFINITY;
        std::size_t hole = 0, leave = 0, arrive = 0;
        for (std::size_t r = 1; r < rings.size(); ++r)
            for (std::size_t i = 0; i < rings[0].size(); ++i)
                for (std::size_t k = 0; k < rings[r].size(); ++k) {
                    const std::uint32_t from = rings[0][i], to = rings[r][k];
                    const double length = glm::distance(points[from], points[to]);
                    if (!(length < shortest)) continue;
                    if (std::any_of(rings.begin(), rings.end(),
                                    [&](const Ring& ring) { return is_crossed(points, ring, from, to); }))
                        continue;
                    shortest = length;
                    hole = r;
                    leave = i;
                    arrive = k;
                }
        if (hole == 0) return {};
        Ring way(rings[hole].begin() + static_cast<std::ptrdiff_t>(arrive), rings[hole].end());
        way.insert(way.end(), rings[hole].begin(), rings[hole].begin() + static_cast<std::ptrdiff_t>(arrive) + 1);
        way.push_back(rings[0][leave]);
        rings[0].insert(rings[0].begin() + static_cast<std::ptrdiff_t>(leave) + 1, way.begin(), way.end());
        rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(hole));
    }
    return rings[0];
}

// How good an ear the k-th corner is: its height over its longest edge; none: -1.
double ear(const FlatPoints& points, const Ring& left, std::size_t k) {
    const std::size_t count = left.size();
    const Corners t = {left[(k + count - 1) % count], left[k], left[(k + 1) % count]};
    const double area = doubled_area(points, t);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 side = points[t[(i + 1) % 3]] - points[t[i]];
        longest = std::max(longest, glm::dot(side, side));
    }
    if (!(area > thinnest * longest)) return -1;
    for (const std::uint32_t other : left) {
        if (std::find(t.begin(), t.end(), other) != t.end()) continue;
        const glm::dvec3 at = barycentric(points, t, points[other]);
        if (std::min({at.x, at.y, at.z}) >= -thinnest) return -1;
    }
    return area / longest;
}

// A polygon cut into triangles, the best ear first; empty if there is a point without one.
std::vector<Corners> cut_into_triangles(const FlatPoints& points, Ring left) {
    std::vector<Corners> triangles;
    while (left.size() >= 3) {
        std::size_t best = 0;
        double quality = -1;
        for (std::size_t k = 0; k < left.size(); ++k)
            if (const double of_k = ear(points, left, k); of_k > quality) {
                best = k;
                quality = of_k;
            }
        if (quality < 0) return {};
        const std::size_t count = left.size();
        triangles.push_back({left[(best + count - 1) % count], left[best], left[(best + 1) % count]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

template <class Value>
bool linear(std::span<const Value> values, const Corners& t, const glm::dvec3& at, std::uint32_t vertex, float same) {
    if (values.empty()) return true;
    const Value between = values[t[0]] * static_cast<float>(at.x) + values[t[1]] * static_cast<float>(at.y) +
                          values[t[2]] * static_cast<float>(at.z);
    return glm::length(between - values[vertex]) <= same * std::max(1.0f, glm::length(values[vertex]));
}

// Whether new triangles carry at every old corner what the old ones did.
bool keeps_look(const FlatPoints& points, const VertexLook& look, const std::vector<Corners>& members,
                const std::vector<std::uint32_t>& piece, const std::vector<Corners>& merged) {
    if (look.normals.empty() && look.texture_coordinates.empty() && look.colors.empty()) return true;
    for (const std::uint32_t i : piece)
        for (const std::uint32_t vertex : members[i]) {
            Corners home{};
            glm::dvec3 inside(-INFINITY);
            for (const Corners& t : merged) {
                const glm::dvec3 at = barycentric(points, t, points[vertex]);
                if (std::min({at.x, at.y, at.z}) <= std::min({inside.x, inside.y, inside.z})) continue;
                inside = at;
                home = t;
            }
            if (!linear(look.normals, home, inside, vertex, same_normal) ||
                !linear(look.texture_coordinates, home, inside, vertex, same_coordinate) ||
                !linear(look.colors, home, inside, vertex, same_color))
                return false;
        }
    return true;
}

// New triangles for a piece, or none.
std::vector<Corners> merged_piece(const FlatPoints& points, const VertexLook& look, const Net& net,
                                  const std::vector<Corners>& members, const std::vector<std::uint32_t>& piece,
                                  double tolerance) {
    std::vector<Ring> rings = rings_of(net, piece);
    std::size_t corners = 0;
    for (Ring& ring : rings) {
        ring = corners_of(points, ring, tolerance);
        if (ring.size() < 3) return {};
        corners += ring.size();
    }
    if (corners == 0 || corners > most_corners || corners + 2 * rings.size() - 4 >= piece.size()) return {};
    const std::vector<Corners> merged = cut_into_triangles(points, joined_rings(points, std::move(rings)));
    double before = 0, after = 0;
    for (const std::uint32_t i : piece) before += doubled_area(points, net.welded[i]);
    for (const Corners& t : merged) after += doubled_area(points, t);
    if (!(std::abs(after - before) <= same_area * before)) return {};
    return keeps_look(points, look, members, piece, merged) ? merged : std::vector<Corners>{};
}

}  // namespace

std::vector<Corners> merged_triangles(const std::vector<glm::vec3>& vertices, const VertexLook& look,
                                      const std::vector<Corners>& triangles, const PlaneGroup& plane,
                                      double tolerance) {
    std::vector<Corners> members;
    for (const std::uint32_t t : plane.triangles) members.push_back(triangles[t]);
    if (members.size() <= 2) return members;
    FlatPoints points(vertices, plane.normal);
    const Net net = net_of(points, members);
    if (net.overlaps) return members;
    std::vector<Corners> all;
    for (const std::vector<std::uint32_t>& piece : net.pieces) {
        const std::vector<Corners> merged = merged_piece(points, look, net, members, piece, tolerance);
        all.insert(all.end(), merged.begin(), merged.end());
        for (std::size_t i = 0; merged.empty() && i < piece.size(); ++i) all.push_back(members[piece[i]]);
    }
    return all;
}

}  // namespace brewster
