#include "bins/corner_sharing.h"

#include <glm/common.hpp>
#include <vector>

#include "bins/linear_fit.h"
#include "shared/bin_layout.h"

namespace brewster {
namespace {

constexpr std::array<std::array<double, 2>, 4> corner_coordinates = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

class CornerSharing {
  public:
    CornerSharing(std::span<PublishedLeaf> leaves,
                  const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate)
        : leaves_(leaves), locate_(locate), states_(leaves.size()) {}

    void run() {
        for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
            for (std::size_t corner = 0; corner < 4; ++corner) resolve(leaf, corner);
    }

  private:
    enum class State : unsigned char { unknown, under_way, done };
    static constexpr std::uint32_t outside = ~0u;
    struct Vertex {
        std::uint32_t x, y;
    };

    Vertex vertex(std::uint32_t leaf, std::size_t corner) const {
        const Box<2>& box = leaves_[leaf].box;
        return {(corner & 1) != 0 ? box.high[0] : box.low[0], (corner & 2) != 0 ? box.high[1] : box.low[1]};
    }

    std::array<double, 2> coordinates(std::uint32_t leaf, const Vertex& v) const {
        const Box<2>& box = leaves_[leaf].box;
        const auto along = [](double x, double low, double high) { return 2 * (x - low) / (high - low) - 1; };
        return {along(v.x, box.low[0], box.high[0]), along(v.y, box.low[1], box.high[1])};
    }

    bool agree(std::uint32_t a, std::uint32_t b, const Vertex& v) const {
        if (a == b) return true;
        const auto xa = coordinates(a, v), xb = coordinates(b, v);
        const glm::dvec3 difference = leaves_[a].linear(xa) - leaves_[b].linear(xb);
        const double fa = LinearFit(*leaves_[a].geometry).variance_factor(xa);
        const double fb = LinearFit(*leaves_[b].geometry).variance_factor(xb);
        const glm::dvec3 variance = fa * leaves_[a].standard_error * leaves_[a].standard_error +
                                    fb * leaves_[b].standard_error * leaves_[b].standard_error;
        for (int band = 0; band < 3; ++band)
            if (difference[band] * difference[band] > 9 * variance[band]) return false;
        return true;
    }

    // Which of the four cells around the vertex (low-low, high-low, low-high, high-high) hang together with `leaf`.
    std::array<std::uint32_t, 4> group(std::uint32_t leaf, const Vertex& v) const {
        std::array<std::uint32_t, 4> around{};
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            const std::uint32_t x = (quadrant & 1) != 0 ? v.x : v.x - 1, y = (quadrant & 2) != 0 ? v.y : v.y - 1;
            around[quadrant] = x < BREWSTER_UV_ONE && y < BREWSTER_UV_ONE ? locate_(x, y) : outside;
        }
        std::array<bool, 4> member{};
        for (std::size_t q = 0; q < 4; ++q) member[q] = around[q] == leaf;
        for (int pass = 0; pass < 3; ++pass) {
            for (std::size_t q = 0; q < 4; ++q) {
                if (!member[q]) continue;
                for (const std::size_t next : {q ^ 1, q ^ 2})
                    if (around[next] != outside && !member[next]) member[next] = agree(around[q], around[next], v);
            }
        }
        for (std::size_t q = 0; q < 4; ++q)
            if (!member[q]) around[q] = outside;
        return around;
    }

    // The value on the edge of a leaf on which the vertex hangs, or nothing if it is a corner of it or not yet known.
    bool edge_value(std::uint32_t leaf, const Vertex& v, glm::dvec3& value) {
        const Box<2>& box = leaves_[leaf].box;
        const bool on_u_end = v.x == box.low[0] || v.x == box.high[0], on_v_end = v.y == box.low[1] || v.y == box.high[1];
        if (on_u_end && on_v_end) return false;
        const std::size_t axis = on_u_end ? 1 : 0;  // the edge runs along this axis
        const std::size_t side = axis == 0 ? (v.y == box.high[1] ? 2u : 0u) : (v.x == box.high[0] ? 1u : 0u);
        const std::size_t first = side, second = side | (axis == 0 ? 1u : 2u);
        if (!resolve(leaf, first) || !resolve(leaf, second)) return false;
        const double t = 0.5 + 0.5 * coordinates(leaf, v)[axis];
        value = leaves_[leaf].corners[first] + t * (leaves_[leaf].corners[second] - leaves_[leaf].corners[first]);
        return true;
    }

    // False if the corner is being resolved further up: borders that wait for each other in a ring keep own means.
    bool resolve(std::uint32_t leaf, std::size_t corner) {
        State& state = states_[leaf][corner];
        if (state == State::done) return true;
        if (state == State::under_way) return false;
        state = State::under_way;
        const Vertex v = vertex(leaf, corner);
        const std::array<std::uint32_t, 4> members = group(leaf, v);
        glm::dvec3 value(0);
        bool hangs = false, inside = true;
        double area = 0;
        glm::dvec3 sum(0);
        for (const std::uint32_t member : members) {
            if (member == outside) continue;
            if (edge_value(member, v, value)) {
                hangs = true;
                break;
            }
            const PublishedLeaf& other = leaves_[member];
            sum += other.geometry->area * other.linear(coordinates(member, v));
            area += other.geometry->area;
            inside = inside && other.geometry->full;
        }
        if (!hangs) value = sum / area;
        // Outside the surface a linear function may well be negative; on it, light is not.
        leaves_[leaf].corners[corner] = inside ? glm::max(value, glm::dvec3(0)) : value;
        state = State::done;
        return true;
    }

    std::span<PublishedLeaf> leaves_;
    const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate_;
    std::vector<std::array<State, 4>> states_;
};

// Mean over the surface of the bilinear function of the corners.
glm::dvec3 bilinear_mean(const PublishedLeaf& leaf) {
    const CellGeometry& g = *leaf.geometry;
    const double xy = g.covariance[1] + g.mean[0] * g.mean[1];
    glm::dvec3 mean(0);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto [sx, sy] = corner_coordinates[corner];
        mean += 0.25 * (1 + sx * g.mean[0] + sy * g.mean[1] + sx * sy * xy) * leaf.corners[corner];
    }
    return mean;
}

}  // namespace

void keep_own_corners(std::span<PublishedLeaf> leaves) {
    for (PublishedLeaf& leaf : leaves)
        for (std::size_t corner = 0; corner < 4; ++corner) leaf.corners[corner] = leaf.linear(corner_coordinates[corner]);
}

void share_corners(std::span<PublishedLeaf> leaves,
                   const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate) {
    CornerSharing(leaves, locate).run();
    for (PublishedLeaf& leaf : leaves)
        if (leaf.geometry->bubble > 1e-3) leaf.bubble = (leaf.density - bilinear_mean(leaf)) / leaf.geometry->bubble;
}

}  // namespace brewster
