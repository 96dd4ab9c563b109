#include "scene/lamp_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/units.h"
#include "optics/axis_across.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

constexpr std::uint32_t no_lamp = std::numeric_limits<std::uint32_t>::max();

/// The first element whose cumulative share is above x.
template <class Element, class Share>
std::size_t index_of(const std::vector<Element>& cumulative, double x, const Share& share_of) {
    const auto at = std::upper_bound(cumulative.begin(), cumulative.end() - 1, x,
                                     [&](double value, const Element& e) { return value < std::invoke(share_of, e); });
    return static_cast<std::size_t>(at - cumulative.begin());
}

/// Densities of a direction, 1/sr, of a lamp with that probability: to a point on `area` square metres, or one of the
/// triangle that is `share` of the lamp.
double density_by_area(double choice, double distance, double cosine, double area) {
    return choice * distance * distance / (cosine * area);
}
double density_by_solid_angle(double choice, double share, const SphericalTriangle& seen) {
    return choice * share / seen.solid_angle();
}

// 1 - cos of the disc's radius, without cancellation.
double versine_of(const Lamp& sun) {
    const double half = std::sin(0.5 * static_cast<double>(sun.angular_radius));
    return 2 * half * half;
}

// E = L pi sin^2(radius) across the beam.
glm::dvec3 disc_radiance(const Lamp& sun) {
    const double sine = std::sin(static_cast<double>(sun.angular_radius));
    return glm::dvec3(sun.intensity) / (pi * sine * sine);
}

}  // namespace

double falloff(const Lamp& lamp, const Vector<double>& direction) {
    if (lamp.kind != LampKind::spot) return 1;
    const double cosine = dot(vector_of(lamp.direction), direction);
    const auto inner = static_cast<double>(lamp.cos_inner), outer = static_cast<double>(lamp.cos_outer);
    if (cosine <= outer) return 0;
    const double ramp = cosine >= inner ? 1 : (cosine - outer) / (inner - outer);
    return ramp * ramp;
}

Vector<double> lamp_axis(const Lamp& lamp, const Vector<double>& direction) {
    const auto part_across = [&](const glm::vec3& axis) {
        const Vector<double> a = vector_of(axis);
        return a - dot(a, direction) * direction;
    };
    const Vector<double> first = part_across(lamp.axis);
    return normalized(dot(first, first) > 1e-12 ? first : part_across(lamp.second_axis));
}

LampLights::LampLights(const Scene& scene) : scene_(scene), lamp_of_chart_(scene.charts.size(), no_lamp) {
    double total = 0;
    for (const Lamp& lamp : scene.lamps) total += static_cast<double>(lamp.mean_power());
    if (!(total > 0)) return;
    double sum = 0;
    for (std::uint32_t i = 0; i < scene.lamps.size(); ++i) {
        const Lamp& lamp = scene.lamps[i];
        choice_.push_back(static_cast<double>(lamp.mean_power()) / total);
        cumulative_.push_back(sum += choice_.back());
        facets_.push_back(lamp.kind == LampKind::area ? facets_of(lamp) : std::vector<Facet>{});
        if (lamp.kind == LampKind::area) lamp_of_chart_[lamp.chart] = i;
        if (lamp.kind == LampKind::sun && lamp.angular_radius > 0) discs_.push_back(i);
    }
}

std::vector<LampLights::Facet> LampLights::facets_of(const Lamp& lamp) const {
    const Chart& chart = scene_.charts[lamp.chart];
    const std::vector<double> shares = scene_.area_shares(chart);
    std::vector<Facet> facets;
    for (std::uint32_t i = 0; i < chart.triangle_count; ++i) {
        constexpr double near = 1.25;  // times the largest distance of a corner
        const Triangle& triangle = scene_.triangles[chart.first_triangle + i];
        const auto corner = [&](std::size_t k) { return vector_of(scene_.vertices[triangle.vertices[k]]); };
        Facet facet;
        facet.before = i > 0 ? shares[i - 1] : 0;
        facet.share = shares[i];
        facet.shape = {corner(0), corner(1) - corner(0), corner(2) - corner(0), vector_of(triangle.margin)};
        const Vector<double> normal = normalized(cross(facet.shape.edge1, facet.shape.edge2));
        facet.normal = triangle.front_chart == lamp.chart ? normal : -normal;
        facet.centre = facet.shape.corner + (1.0 / 3) * (facet.shape.edge1 + facet.shape.edge2);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector<double> out = corner(k) - facet.centre;
            facet.near = std::max(facet.near, near * near * dot(out, out));
        }
        facets.push_back(facet);
    }
    return facets;
}

std::optional<LampLight> LampLights::sample(const Vector<double>& point, double choice, double u, double v) const {
    return sample_lamp(index_of(cumulative_, choice, std::identity()), point, u, v);
}

std::optional<LampLight> LampLights::sample(const Vector<double>& point, double u, double v) const {
    const std::size_t lamp = index_of(cumulative_, u, std::identity());
    const double before = lamp > 0 ? cumulative_[lamp - 1] : 0;
    constexpr double below_one = 1 - 0x1p-53;
    return sample_lamp(lamp, point, std::min((u - before) / (cumulative_[lamp] - before), below_one), v);
}

std::optional<LampLight> LampLights::sample_lamp(std::size_t index, const Vector<double>& point, double u,
                                                 double v) const {
    const Lamp& lamp = scene_.lamps[index];
    LampLight light;
    light.lamp = static_cast<std::uint32_t>(index);
    light.choice = choice_[index];
    if (lamp.kind == LampKind::sun) {
        const Vector<double> towards = normalized(-vector_of(lamp.direction));
        light.distance = std::numeric_limits<double>::infinity();
        light.direction = towards;
        light.radiance = glm::dvec3(lamp.intensity);
        if (lamp.angular_radius > 0) {
            const double versine = u * versine_of(lamp), sine = std::sqrt(versine * (2 - versine));
            const Vector<double> x = axis_across(towards, towards), y = cross(towards, x);
            light.direction = normalized((1 - versine) * towards + (sine * std::cos(2 * pi * v)) * x +
                                         (sine * std::sin(2 * pi * v)) * y);
            light.radiance = disc_radiance(lamp);
            light.pdf = light.choice / (2 * pi * versine_of(lamp));
        }
        return light;
    }
    if (lamp.kind != LampKind::area) {
        const Vector<double> way = vector_of(lamp.position) - point;
        light.distance = std::sqrt(dot(way, way));
        if (!(light.distance > 0)) return {};
        light.direction = (1 / light.distance) * way;
        const double share = falloff(lamp, -light.direction);
        if (share <= 0) return {};
        light.radiance = share / (light.distance * light.distance) * glm::dvec3(lamp.intensity);
        return light;
    }
    const std::vector<Facet>& facets = facets_[index];
    const std::size_t k = index_of(facets, u, &Facet::share);
    const Facet& facet = facets[k];
    const Barycentric<double> place{(u - facet.before) / (facet.share - facet.before), v};
    light.triangle = scene_.charts[lamp.chart].first_triangle + static_cast<std::uint32_t>(k);
    light.radiance = glm::dvec3(lamp.intensity);
    if (facet.is_near(point) && sample_near(facet, point, place.b1, place.b2, light)) {
        if (!(light.pdf > 0)) return {};
        return light;
    }
    const Barycentric<double> b = place.b1 + place.b2 > 1 ? Barycentric<double>{1 - place.b1, 1 - place.b2} : place;
    const Vector<double> way = point_inside(facet.shape, b) - point;
    light.distance = std::sqrt(dot(way, way));
    if (!(light.distance > 0)) return {};
    light.direction = (1 / light.distance) * way;
    const double cosine = -dot(facet.normal, light.direction);
    if (!(cosine > 0)) return {};
    light.pdf =
        density_by_area(light.choice, light.distance, cosine, static_cast<double>(scene_.charts[lamp.chart].area));
    if (!std::isfinite(light.pdf)) return {};
    return light;
}

/// The facet on the sphere of directions; none if it is flat there: it has no peak that matters, and rounding would show.
std::optional<SphericalTriangle> LampLights::Facet::seen_from(const Vector<double>& point) const {
    constexpr double least = 1e-3;  // sr
    const Vector<double> first = shape.corner - point;
    const SphericalTriangle seen({first, first + shape.edge1, first + shape.edge2});
    if (!(seen.solid_angle() > least)) return {};
    return seen;
}

/// False if the facet is to be sampled by area after all; a density of zero if it turns its back.
bool LampLights::sample_near(const Facet& facet, const Vector<double>& point, double u, double v, LampLight& light) {
    const std::optional<SphericalTriangle> seen = facet.seen_from(point);
    if (!seen) return false;
    light.direction = seen->sample(u, v);
    const double cosine = -dot(facet.normal, light.direction);
    light.distance = dot(facet.normal, point - facet.shape.corner) / cosine;
    if (cosine > 0 && light.distance > 0 && std::isfinite(light.distance))
        light.pdf = density_by_solid_angle(light.choice, facet.share - facet.before, *seen);
    return true;
}

double LampLights::pdf_of_area(std::uint32_t chart, std::uint32_t triangle, const Vector<double>& point,
                               const Vector<double>& normal, const Vector<double>& direction, double distance) const {
    const std::uint32_t lamp = lamp_of_chart_[chart];
    if (lamp == no_lamp) return 0;
    const double cosine = -dot(normal, direction);
    if (cosine <= 0) return 0;
    const Facet& facet = facets_[lamp][triangle - scene_.charts[chart].first_triangle];
    if (facet.is_near(point))
        if (const std::optional<SphericalTriangle> seen = facet.seen_from(point))
            return density_by_solid_angle(choice_[lamp], facet.share - facet.before, *seen);
    return density_by_area(choice_[lamp], distance, cosine, static_cast<double>(scene_.charts[chart].area));
}

std::optional<LampLight> LampLights::disc_seen(std::uint32_t index, const Vector<double>& direction) const {
    const Lamp& lamp = scene_.lamps[index];
    const Vector<double> off = direction + normalized(vector_of(lamp.direction));
    if (0.5 * dot(off, off) >= versine_of(lamp)) return {};
    LampLight light;
    light.lamp = index;
    light.direction = direction;
    light.distance = std::numeric_limits<double>::infinity();
    light.radiance = disc_radiance(lamp);
    light.choice = choice_[index];
    light.pdf = light.choice / (2 * pi * versine_of(lamp));
    return light;
}

}  // namespace brewster
