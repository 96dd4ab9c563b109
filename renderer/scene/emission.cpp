#include "scene/emission.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"

namespace brewster {
namespace {

// The point of a triangle for two numbers, by folding the unit square's far half back: barycentric b1, b2.
// Unlike the square root, this keeps a lattice of numbers a lattice of points.
std::array<float, 2> fold(float x, float y) {
    if (x + y > 1.0f) return {1.0f - x, 1.0f - y};
    return {x, y};
}

}  // namespace

LampSampler::LampSampler(const Scene& scene) : scene_(scene) {
    for (const Lamp& lamp : scene.lamps) {
        cumulative_.push_back(lamp.kind == LampKind::area ? scene.area_shares(scene.charts[lamp.chart])
                                                          : std::vector<double>{});
        suns_.push_back(lamp.kind == LampKind::sun
                            ? sun_rectangle(scene.low, scene.high, lamp.direction, lamp.angular_radius)
                            : SunRectangle{});
    }
}

Emission LampSampler::emit(std::uint32_t index, const std::array<float, 4>& x) const {
    const Lamp& lamp = scene_.lamps[index];
    switch (lamp.kind) {
        case LampKind::area: {
            const Chart& chart = scene_.charts[lamp.chart];
            const std::vector<double>& shares = cumulative_[index];
            const auto k =
                static_cast<std::size_t>(std::upper_bound(shares.begin(), shares.end(), x[0]) - shares.begin());
            const double before = k ? shares[k - 1] : 0.0;
            const Triangle& triangle = scene_.triangles[chart.first_triangle + k];
            const double within = (static_cast<double>(x[0]) - before) / (shares[k] - before);
            const auto [b1, b2] = fold(static_cast<float>(within), x[1]);
            const Frame frame = chart.curved ? chart.frame_about(scene_.facet_normal(triangle)) : chart.frame();
            return {scene_.point_inside(triangle, b1, b2), sample_cosine(frame.u, frame.v, frame.normal, x[2], x[3]),
                    chart.first_triangle + static_cast<std::uint32_t>(k)};
        }
        case LampKind::sun: {
            const SunRectangle& sun = suns_[index];
            return {sun.centre + (2.0f * x[0] - 1.0f) * sun.half_u + (2.0f * x[1] - 1.0f) * sun.half_v,
                    sample_disc(lamp, x[2], x[3]), no_triangle};
        }
        case LampKind::point:
            return {lamp.position, sample_sphere(x[2], x[3]), no_triangle};
        case LampKind::spot:
            return {lamp.position, sample_spot(lamp, x[2], x[3]), no_triangle};
    }
    return {};
}

float LampSampler::pdf(std::uint32_t index, glm::vec3 direction) const {
    const Lamp& lamp = scene_.lamps[index];
    switch (lamp.kind) {
        case LampKind::area: {
            const Chart& chart = scene_.charts[lamp.chart];
            BREWSTER_CHECK(!chart.curved, chart.mesh + " is curved");
            return pdf_cosine(chart.normal, direction) / static_cast<float>(chart.area);
        }
        case LampKind::sun:
            return (lamp.angular_radius > 0 ? pdf_disc(lamp, direction) : 1.0f) / suns_[index].area;
        case LampKind::point:
            return pdf_sphere();
        case LampKind::spot:
            return pdf_spot(lamp, direction);
    }
    return 0.0f;
}

}  // namespace brewster
