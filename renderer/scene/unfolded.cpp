#include "scene/unfolded.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <span>

namespace brewster {
namespace {

constexpr std::uint32_t none = 0xffffffffu;
using Corners = std::array<glm::dvec2, 3>;

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

glm::dvec2 middle_of(const Corners& t) {
    return (t[0] + t[1] + t[2]) / 3.0;
}

bool contains(const Corners& t, glm::dvec2 p) {
    return cross(t[1] - t[0], p - t[0]) > 0 && cross(t[2] - t[1], p - t[1]) > 0 && cross(t[0] - t[2], p - t[2]) > 0;
}

// Numbers in rows: those of row r stand at [first[r], first[r + 1]).
struct Rows {
    std::vector<std::uint32_t> first, members;

    std::span<const std::uint32_t> operator[](std::size_t row) const {
        return {members.data() + first[row], first[row + 1] - first[row]};
    }
};

// `visit(add)` must call add(row, member) for everything, the same way each time.
template <class Visit>
Rows rows_of(std::size_t rows, const Visit& visit) {
    Rows result;
    result.first.assign(rows + 1, 0);
    visit([&](std::size_t row, std::uint32_t) { ++result.first[row + 1]; });
    for (std::size_t r = 0; r < rows; ++r) result.first[r + 1] += result.first[r];
    result.members.resize(result.first[rows]);
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    visit([&](std::size_t row, std::uint32_t member) { result.members[next[row]++] = member; });
    return result;
}

// A grid of about one cell a triangle, and the triangles whose bounds reach into each cell.
class Grid {
  public:
    explicit Grid(const std::vector<Corners>& triangles) : low_(INFINITY) {
        glm::dvec2 high(-INFINITY);
        for (const Corners& t : triangles)
            for (const glm::dvec2& p : t) {
                low_ = glm::min(low_, p);
                high = glm::max(high, p);
            }
        const glm::dvec2 extent = high - low_;
        cell_ = std::sqrt(extent.x * extent.y / static_cast<double>(triangles.size()));
        across_ = static_cast<std::size_t>(extent.x / cell_) + 1;
        down_ = static_cast<std::size_t>(extent.y / cell_) + 1;
        rows_ = rows_of(across_ * down_, [&](const auto& add) {
            for (std::uint32_t i = 0; i < triangles.size(); ++i)
                visit(triangles[i], [&](std::size_t cell) {
                    add(cell, i);
                    return true;
                });
        });
    }

    std::span<const std::uint32_t> at(glm::dvec2 p) const { return rows_[row(p.y) * across_ + column(p.x)]; }
    std::span<const std::uint32_t> in(std::size_t cell) const { return rows_[cell]; }

    // Calls `use(cell)` for the cells under a triangle's bounds until it says false; returns whether it never did.
    template <class Use>
    bool visit(const Corners& t, const Use& use) const {
        const glm::dvec2 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
        for (std::size_t y = row(low.y); y <= row(high.y); ++y)
            for (std::size_t x = column(low.x); x <= column(high.x); ++x)
                if (!use(y * across_ + x)) return false;
        return true;
    }

  private:
    std::size_t column(double x) const { return std::min(static_cast<std::size_t>((x - low_.x) / cell_), across_ - 1); }
    std::size_t row(double y) const { return std::min(static_cast<std::size_t>((y - low_.y) / cell_), down_ - 1); }

    glm::dvec2 low_;
    double cell_ = 1;
    std::size_t across_ = 1, down_ = 1;
    Rows rows_;
};

}  // namespace

std::vector<std::uint32_t> unfolded(const std::vector<std::array<glm::dvec2, 3>>& triangles,
                                    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& neighbours) {
    const Grid grid(triangles);
    const Rows beside = rows_of(triangles.size(), [&](const auto& add) {
        for (const auto& [a, b] : neighbours) {
            add(a, b);
            add(b, a);
        }
    });
    std::vector<std::uint32_t> layer_of(triangles.size(), none);
    const auto has_room = [&](std::uint32_t index, std::uint32_t layer) {
        const Corners& own = triangles[index];
        const glm::dvec2 middle = middle_of(own);
        for (const std::uint32_t other : grid.at(middle))
            if (layer_of[other] == layer && contains(triangles[other], middle)) return false;
        return grid.visit(own, [&](std::size_t cell) {
            const auto members = grid.in(cell);
            return std::none_of(members.begin(), members.end(), [&](std::uint32_t other) {
                return layer_of[other] == layer && contains(own, middle_of(triangles[other]));
            });
        });
    };
    std::uint32_t layer = 0;
    std::vector<std::uint32_t> front;
    for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
        if (layer_of[seed] != none) continue;
        front.assign(1, seed);
        layer_of[seed] = layer;
        for (std::size_t i = 0; i < front.size(); ++i) {
            for (const std::uint32_t next : beside[front[i]]) {
                if (layer_of[next] != none || !has_room(next, layer)) continue;
                layer_of[next] = layer;
                front.push_back(next);
            }
        }
        ++layer;
    }
    return layer_of;
}

}  // namespace brewster
