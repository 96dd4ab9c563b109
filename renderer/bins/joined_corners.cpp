#include "bins/joined_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "bins/linear_fit.h"
#include "shared/bin_layout.h"

namespace brewster {
namespace {

constexpr std::array<std::array<double, 2>, 4> corner_coordinates = {{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

struct Vertex {
    std::uint32_t x, y;
};

/// A corner's value as a mix of free values: itself one, or a point between those at the ends of an edge.
struct Term {
    std::uint32_t unknown;
    double weight;
};
using Mix = std::span<const Term>;

/// Finds which corners share a value.
class Joints {
  public:
    Joints(std::span<const PublishedLeaf> leaves,
           const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate)
        : leaves_(leaves), locate_(locate), states_(leaves.size()), unknowns_(leaves.size()), places_(leaves.size()) {
        terms_.reserve(2 * leaves.size());
        for (auto& corners : unknowns_) corners.fill(none);
        for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf)
            for (std::size_t corner = 0; corner < 4; ++corner) resolve(leaf, corner);
    }

    std::uint32_t unknown_count() const { return unknown_count_; }
    Mix mix(std::size_t leaf, std::size_t corner) const {
        const Place& place = places_[leaf][corner];
        return {&terms_[place.begin], place.count};
    }

  private:
    enum class State : unsigned char { unknown, under_way, done };
    static constexpr std::uint32_t none = ~0u;
    struct Place {  // of a mix in terms_
        std::uint32_t begin = 0, count = 0;
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

    // Light on a plane jumps where something touches it or hides a small lamp, and there by a lot; elsewhere fits
    // differ at a corner by noise and by the curvature that a linear fit misses, which is about as large.
    bool agree(std::uint32_t a, std::uint32_t b, const Vertex& v) const {
        constexpr double deviations = 7, slight = 0.3;
        if (a == b) return true;
        const auto xa = coordinates(a, v), xb = coordinates(b, v);
        const glm::dvec3 value_a = leaves_[a].linear(xa), value_b = leaves_[b].linear(xb);
        const double fa = LinearFit<2>(*leaves_[a].geometry, leaves_[a].geometry->area).variance_factor(xa);
        const double fb = LinearFit<2>(*leaves_[b].geometry, leaves_[b].geometry->area).variance_factor(xb);
        for (int band = 0; band < 3; ++band) {
            const double ea = leaves_[a].standard_error[band], eb = leaves_[b].standard_error[band];
            const double difference = std::abs(value_a[band] - value_b[band]);
            const bool noise = difference <= deviations * std::sqrt(fa * ea * ea + fb * eb * eb);
            if (!noise && difference > slight * std::max(value_a[band], value_b[band])) return false;
        }
        return true;
    }

    // Which of the four cells around a corner's vertex (low-low, high-low, low-high, high-high) hang together with `leaf`.
    std::array<std::uint32_t, 4> group(std::uint32_t leaf, std::size_t corner, const Vertex& v) const {
        std::array<std::uint32_t, 4> around{};
        const std::size_t own = 3 - corner;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            if (quadrant == own) {
                around[quadrant] = leaf;
                continue;
            }
            const std::uint32_t x = (quadrant & 1) != 0 ? v.x : v.x - 1, y = (quadrant & 2) != 0 ? v.y : v.y - 1;
            around[quadrant] = x < BREWSTER_UV_ONE && y < BREWSTER_UV_ONE ? locate_(x, y) : none;
        }
        std::array<bool, 4> member{};
        for (std::size_t q = 0; q < 4; ++q) member[q] = around[q] == leaf;
        for (int pass = 0; pass < 3; ++pass) {
            for (std::size_t q = 0; q < 4; ++q) {
                if (!member[q]) continue;
                for (const std::size_t next : {q ^ 1, q ^ 2})
                    if (around[next] != none && !member[next]) member[next] = agree(around[q], around[next], v);
            }
        }
        for (std::size_t q = 0; q < 4; ++q)
            if (!member[q]) around[q] = none;
        return around;
    }

    // The corner of the leaf at the vertex, or 4 if the vertex lies inside one of its edges.
    std::size_t corner_at(std::uint32_t leaf, const Vertex& v) const {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Vertex own = vertex(leaf, corner);
            if (own.x == v.x && own.y == v.y) return corner;
        }
        return 4;
    }

    // The mix of the ends of the leaf's edge that the vertex lies in. False if those are not known yet.
    bool hang_on_edge(std::uint32_t leaf, const Vertex& v, std::vector<Term>& terms) {
        const Box<2>& box = leaves_[leaf].box;
        const bool edge_along_v = v.x == box.low[0] || v.x == box.high[0];
        const std::size_t first = edge_along_v ? (v.x == box.high[0] ? 1u : 0u) : (v.y == box.high[1] ? 2u : 0u);
        const std::size_t second = first | (edge_along_v ? 2u : 1u);
        if (!resolve(leaf, first) || !resolve(leaf, second)) return false;
        const double t = 0.5 + 0.5 * coordinates(leaf, v)[edge_along_v ? 1 : 0];
        terms.clear();
        for (const auto& [end, share] : {std::pair(first, 1 - t), std::pair(second, t)})
            for (const Term& term : mix(leaf, end)) terms.push_back({term.unknown, share * term.weight});
        return true;
    }

    // False if the corner is being resolved further up: borders that wait for each other in a ring stay free there.
    bool resolve(std::uint32_t leaf, std::size_t corner) {
        if (states_[leaf][corner] == State::done) return true;
        if (states_[leaf][corner] == State::under_way) return false;
        states_[leaf][corner] = State::under_way;
        const Vertex v = vertex(leaf, corner);
        std::uint32_t first = none;  // the member that names the shared value
        bool hangs = false, any_edge = false;
        std::vector<Term> terms;
        const std::array<std::uint32_t, 4> members = group(leaf, corner, v);
        for (const std::uint32_t member : members) {
            if (member == none) continue;
            if (corner_at(member, v) == 4) {
                any_edge = true;
                hangs = hangs || hang_on_edge(member, v, terms);
            } else {
                first = std::min(first, member);
            }
        }
        if (!hangs) {
            std::uint32_t& unknown = unknowns_[first][corner_at(first, v)];
            if (unknown == none) unknown = unknown_count_++;
            terms.assign(1, {unknown, 1.0});
        }
        const Place place{static_cast<std::uint32_t>(terms_.size()), static_cast<std::uint32_t>(terms.size())};
        terms_.insert(terms_.end(), terms.begin(), terms.end());
        settle(leaf, corner, place);
        // Where no edge waits for others the group is the same seen from each of its members, and so is the value.
        if (any_edge) return true;
        for (const std::uint32_t member : members)
            if (member != none) settle(member, corner_at(member, v), place);
        return true;
    }

    void settle(std::uint32_t leaf, std::size_t corner, const Place& place) {
        places_[leaf][corner] = place;
        states_[leaf][corner] = State::done;
    }

    std::span<const PublishedLeaf> leaves_;
    const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate_;
    std::vector<std::array<State, 4>> states_;
    std::vector<std::array<std::uint32_t, 4>> unknowns_;
    std::vector<std::array<Place, 4>> places_;
    std::vector<Term> terms_;
    std::uint32_t unknown_count_ = 0;
};

/// One cell's part of the least-squares problem: the corners' hat functions (1 + s x)(1 + t y) / 4 against each other
/// and against the linear fit, integrated over the surface.
struct Element {
    std::array<std::array<double, 4>, 4> mass{};
    std::array<glm::dvec3, 4> load{};
};

Element element_of(const PublishedLeaf& leaf) {
    const CellGeometry& g = *leaf.geometry;
    const double x = g.mean[0], y = g.mean[1];
    const double xx = g.covariance[0] + x * x, xy = g.covariance[1] + x * y, yy = g.covariance[2] + y * y;
    Element element;
    // Corners outside the surface carry next to nothing; a little of their own fit keeps them defined.
    const double hold = g.full ? 0 : 1e-4 * g.area;
    for (std::size_t a = 0; a < 4; ++a) {
        const auto [sa, ta] = corner_coordinates[a];
        for (std::size_t b = 0; b < 4; ++b) {
            const auto [sb, tb] = corner_coordinates[b];
            const double s = sa + sb, ss = sa * sb, t = ta + tb, tt = ta * tb;
            element.mass[a][b] = g.area / 16 *
                                 (1 + s * x + ss * xx + t * y + s * t * xy + ss * t * g.xxy + tt * yy + s * tt * g.xyy +
                                  ss * tt * g.xxyy);
        }
        const glm::dvec3 constant = leaf.density - x * leaf.slopes[0] - y * leaf.slopes[1];
        element.load[a] = g.area / 4 *
                          ((1 + sa * x + ta * y + sa * ta * xy) * constant +
                           (x + sa * xx + ta * xy + sa * ta * g.xxy) * leaf.slopes[0] +
                           (y + sa * xy + ta * yy + sa * ta * g.xyy) * leaf.slopes[1]);
        element.mass[a][a] += hold;
        element.load[a] += hold * leaf.linear(corner_coordinates[a]);
    }
    return element;
}

/// Mean square of the function with these corners, over the surface.
glm::dvec3 mean_square(const Element& element, double area, const std::array<glm::dvec3, 4>& corners) {
    glm::dvec3 sum(0);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) sum += element.mass[a][b] * corners[a] * corners[b];
    return sum / area;
}

using Values = std::vector<glm::dvec3>;

std::array<glm::dvec3, 4> corners_from(const Joints& joints, std::size_t leaf, const Values& values) {
    std::array<glm::dvec3, 4> corners{};
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (const Term& term : joints.mix(leaf, corner)) corners[corner] += term.weight * values[term.unknown];
    return corners;
}

glm::dvec3 dot(const Values& a, const Values& b) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Conjugate gradients on the mass matrix, all bands at once, scaled by its diagonal. A mass matrix is well
/// conditioned: a dozen steps reach the tolerance.
class Projection {
  public:
    Projection(std::span<const PublishedLeaf> leaves, const Joints& joints) : leaves_(leaves), joints_(joints) {
        elements_.reserve(leaves.size());
        for (const PublishedLeaf& leaf : leaves) elements_.push_back(element_of(leaf));
    }

    const Element& element(std::size_t leaf) const { return elements_[leaf]; }

    Values solve() const {
        const std::size_t n = joints_.unknown_count();
        Values x(n), residual(n), diagonal(n);
        for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
            for (std::size_t corner = 0; corner < 4; ++corner) {
                for (const Term& term : joints_.mix(leaf, corner)) {
                    residual[term.unknown] += term.weight * elements_[leaf].load[corner];
                    diagonal[term.unknown] += term.weight * term.weight * elements_[leaf].mass[corner][corner];
                }
            }
        }
        Values z(n), image(n);
        const auto precondition = [&] {
            for (std::size_t i = 0; i < n; ++i) z[i] = residual[i] / diagonal[i];
        };
        precondition();
        Values direction = z;
        glm::dvec3 rz = dot(residual, z);
        const glm::dvec3 target = 1e-14 * rz;
        for (int step = 0; step < 100; ++step) {
            if (rz.x <= target.x && rz.y <= target.y && rz.z <= target.z) break;
            apply(direction, image);
            const glm::dvec3 alpha = ratio(rz, dot(direction, image));
            for (std::size_t i = 0; i < n; ++i) {
                x[i] += alpha * direction[i];
                residual[i] -= alpha * image[i];
            }
            precondition();
            const glm::dvec3 next = dot(residual, z), beta = ratio(next, rz);
            rz = next;
            for (std::size_t i = 0; i < n; ++i) direction[i] = z[i] + beta * direction[i];
        }
        return x;
    }

  private:
    static glm::dvec3 ratio(const glm::dvec3& a, const glm::dvec3& b) {
        return {b.x > 0 ? a.x / b.x : 0, b.y > 0 ? a.y / b.y : 0, b.z > 0 ? a.z / b.z : 0};
    }

    void apply(const Values& values, Values& image) const {
        std::fill(image.begin(), image.end(), glm::dvec3(0));
        for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf) {
            const std::array<glm::dvec3, 4> corners = corners_from(joints_, leaf, values);
            for (std::size_t a = 0; a < 4; ++a) {
                glm::dvec3 sum(0);
                for (std::size_t b = 0; b < 4; ++b) sum += elements_[leaf].mass[a][b] * corners[b];
                for (const Term& term : joints_.mix(leaf, a)) image[term.unknown] += term.weight * sum;
            }
        }
    }

    std::span<const PublishedLeaf> leaves_;
    const Joints& joints_;
    std::vector<Element> elements_;
};

}  // namespace

void keep_own_corners(std::span<PublishedLeaf> leaves) {
    for (PublishedLeaf& leaf : leaves)
        for (std::size_t corner = 0; corner < 4; ++corner)
            leaf.corners[corner] = leaf.linear(corner_coordinates[corner]);
}

void join_corners(std::span<PublishedLeaf> leaves,
                  const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& locate) {
    if (leaves.size() < 2) return keep_own_corners(leaves);
    const Joints joints(leaves, locate);
    const Projection projection(leaves, joints);
    const Values values = projection.solve();
    std::vector<double> shares(joints.unknown_count());  // how many cells' worth of corners determine a value
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (const Term& term : joints.mix(leaf, corner)) shares[term.unknown] += term.weight;
    for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
        leaves[leaf].corners = corners_from(joints, leaf, values);
        double freedom = 0;
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (const Term& term : joints.mix(leaf, corner)) freedom += term.weight / shares[term.unknown];
        leaves[leaf].freedom = std::min(freedom, 3.0);
        std::array<glm::dvec3, 4> changes = leaves[leaf].corners;
        for (std::size_t corner = 0; corner < 4; ++corner)
            changes[corner] -= leaves[leaf].linear(corner_coordinates[corner]);
        leaves[leaf].bend = mean_square(projection.element(leaf), leaves[leaf].geometry->area, changes);
    }
}

}  // namespace brewster
