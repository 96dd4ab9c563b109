#include "scene/contacts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "scene/box_tree.h"

namespace brewster {
namespace {

constexpr std::size_t most_surfaces = 20000;
constexpr std::size_t most_contacts = 64;
constexpr float touching = 1e-5f;   // distance to the plane, of the larger of both sizes
constexpr float same_line = 1e-4f;  // in (u, v)
constexpr float shortest = 1e-3f;   // in (u, v)

Box triangle_box(const Scene& scene, const Triangle& triangle) {
    const glm::vec3 a = scene.vertices[triangle.vertices[0]], b = scene.vertices[triangle.vertices[1]],
                    c = scene.vertices[triangle.vertices[2]];
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

Box chart_box(const Chart& chart) {
    const glm::vec3 u = chart.size_u * chart.axis_u, v = chart.size_v * chart.axis_v;
    const glm::vec3 a = chart.origin, b = a + u, c = a + v, d = a + u + v;
    const glm::vec3 slack(2.0f * touching * chart.size());
    return {glm::min(glm::min(a, b), glm::min(c, d)) - slack, glm::max(glm::max(a, b), glm::max(c, d)) + slack};
}

// The part of a segment inside the unit square (Liang and Barsky 1984), unless it is short or runs along the border.
std::optional<Contact> clipped(Contact line) {
    const glm::vec2 d = line.to - line.from;
    float enter = 0, leave = 1;
    for (int k = 0; k < 2; ++k) {
        for (const float side : {-1.0f, 1.0f}) {
            const float rate = side * d[k];
            const float room = side > 0 ? 1.0f - line.from[k] : line.from[k];
            if (rate == 0) {
                if (room < 0) return {};
            } else if (rate > 0) {
                leave = std::min(leave, room / rate);
            } else {
                enter = std::max(enter, room / rate);
            }
        }
    }
    if (!(enter < leave)) return {};
    const Contact inside{line.from + enter * d, line.from + leave * d};
    if (glm::length(inside.to - inside.from) < shortest) return {};
    for (int k = 0; k < 2; ++k) {
        if (std::max(inside.from[k], inside.to[k]) < same_line) return {};
        if (std::min(inside.from[k], inside.to[k]) > 1.0f - same_line) return {};
    }
    return inside;
}

// Joins b to a if both lie on one line and meet.
bool join(Contact& a, const Contact& b) {
    const float length = glm::length(a.to - a.from);
    const glm::vec2 along = (a.to - a.from) / length, across{-along.y, along.x};
    if (std::abs(glm::dot(b.from - a.from, across)) > same_line ||
        std::abs(glm::dot(b.to - a.from, across)) > same_line)
        return false;
    const float s = glm::dot(b.from - a.from, along), t = glm::dot(b.to - a.from, along);
    if (std::max(s, t) < -same_line || std::min(s, t) > length + same_line) return false;
    const glm::vec2 start = a.from;
    a.from = start + std::min({0.0f, s, t}) * along;
    a.to = start + std::max({length, s, t}) * along;
    return true;
}

std::vector<Contact> joined(std::vector<Contact> lines) {
    std::stable_sort(lines.begin(), lines.end(), [](const Contact& a, const Contact& b) {
        return glm::length(a.to - a.from) > glm::length(b.to - b.from);
    });
    if (lines.size() > 4 * most_contacts) lines.resize(4 * most_contacts);
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Contact> kept;
        for (const Contact& line : lines) {
            const auto home = std::find_if(kept.begin(), kept.end(), [&](Contact& other) { return join(other, line); });
            if (home == kept.end()) kept.push_back(line);
        }
        changed = kept.size() < lines.size();
        lines = std::move(kept);
    }
    if (lines.size() > most_contacts) lines.resize(most_contacts);
    return lines;
}

// Collects what other triangles leave on one chart's plane.
class PlaneSection {
  public:
    PlaneSection(const Scene& scene, const Chart& chart) : scene_(scene), chart_(chart) {}

    void add(const Triangle& triangle) {
        glm::vec3 p[3];
        float height[3];
        const float near = touching * std::max(chart_.size(), scene_.charts[triangle.front_chart].size());
        int on_plane = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = scene_.vertices[triangle.vertices[k]];
            height[k] = glm::dot(p[k] - chart_.origin, chart_.normal);
            if (std::abs(height[k]) <= near) height[k] = 0;
            on_plane += height[k] == 0;
        }
        if (on_plane == 3) {
            for (std::size_t k = 0; k < 3; ++k) add_outline(p[k], p[(k + 1) % 3]);
            return;
        }
        glm::vec3 ends[2];
        int count = 0;
        for (std::size_t k = 0; k < 3 && count < 2; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (height[k] == 0) {
                ends[count++] = p[k];
            } else if (height[k] * height[next] < 0) {
                ends[count++] = p[k] + height[k] / (height[k] - height[next]) * (p[next] - p[k]);
            }
        }
        if (count == 2) add_line(ends[0], ends[1]);
    }

    std::vector<Contact> contacts() {
        for (const auto& [edge, uses] : outline_)
            if (uses == 1) add_line({edge[0], edge[1], edge[2]}, {edge[3], edge[4], edge[5]});
        return joined(std::move(lines_));
    }

  private:
    // Of triangles that lie in the plane only the outline counts: inner edges are there twice.
    void add_outline(glm::vec3 a, glm::vec3 b) {
        std::array<float, 6> edge = {a.x, a.y, a.z, b.x, b.y, b.z};
        const std::array<float, 6> turned = {b.x, b.y, b.z, a.x, a.y, a.z};
        ++outline_[std::min(edge, turned)];
    }

    void add_line(glm::vec3 a, glm::vec3 b) {
        if (const auto inside = clipped({chart_.unit_coordinates(a), chart_.unit_coordinates(b)}))
            lines_.push_back(*inside);
    }

    const Scene& scene_;
    const Chart& chart_;
    std::vector<Contact> lines_;
    std::map<std::array<float, 6>, int> outline_;
};

}  // namespace

std::vector<std::vector<Contact>> chart_contacts(const Scene& scene) {
    std::vector<std::vector<Contact>> contacts(scene.charts.size());
    if (scene.triangles.empty() || scene.triangles.back().surface >= most_surfaces) return contacts;
    std::vector<Box> boxes;
    std::vector<std::uint32_t> planar;  // triangles, beside boxes
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        if (scene.charts[scene.triangles[t].front_chart].curved) continue;
        boxes.push_back(triangle_box(scene, scene.triangles[t]));
        planar.push_back(t);
    }
    if (boxes.empty()) return contacts;
    const BoxTree tree(std::move(boxes));
    for (std::uint32_t i = 0; i < scene.charts.size(); ++i) {
        const Chart& chart = scene.charts[i];
        if (chart.curved) continue;
        if (scene.triangles[chart.first_triangle].front_chart != i) {  // a back: its front stands before it
            for (const Contact& line : contacts[i - 1])
                contacts[i].push_back({{line.from.y, line.from.x}, {line.to.y, line.to.x}});
            continue;
        }
        PlaneSection section(scene, chart);
        for (const std::uint32_t box : tree.overlapping(chart_box(chart))) {
            const Triangle& triangle = scene.triangles[planar[box]];
            if (triangle.surface != chart.surface) section.add(triangle);
        }
        contacts[i] = section.contacts();
    }
    return contacts;
}

}  // namespace brewster
