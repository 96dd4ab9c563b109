#include "app/inspection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/seen_point.h"

namespace brewster {

std::array<double, 4> SeenLight::mean() const {
    std::array<double, 4> sum{};
    for (const auto& band : stokes)
        for (std::size_t j = 0; j < 4; ++j) sum[j] += band[j] / band_count;
    return sum;
}

std::array<double, 4> SeenLight::mean_error() const {
    // Bands share their photons, so their errors go together.
    std::array<double, 4> sum{};
    for (const auto& band : error)
        for (std::size_t j = 0; j < 4; ++j) sum[j] += band[j] / band_count;
    return sum;
}

double SeenLight::dolp() const {
    const auto s = mean();
    return s[0] > 0 ? std::min(1.0, std::hypot(s[1], s[2]) / s[0]) : 0.0;
}

double SeenLight::docp() const {
    const auto s = mean();
    return s[0] > 0 ? std::clamp(s[3] / s[0], -1.0, 1.0) : 0.0;
}

double SeenLight::aolp_degrees() const {
    const auto s = mean();
    return degrees(0.5 * std::atan2(s[2], s[1]));
}

double SeenLight::luminance() const {
    return 0.2126 * stokes[0][0] + 0.7152 * stokes[1][0] + 0.0722 * stokes[2][0];
}

double SeenLight::dolp_floor() const {
    const auto s = mean(), e = mean_error();
    return s[0] > 0 ? std::hypot(e[1], e[2]) / s[0] : 0.0;
}

double SeenLight::passed(double angle) const {
    const auto s = mean();
    const double twice = 2 * radians(angle);
    return s[0] > 0 ? 0.5 * (s[0] + s[1] * std::cos(twice) + s[2] * std::sin(twice)) / s[0] : 0.0;
}

SeenLight seen_light(const StokesPicture& picture, glm::ivec2 low, glm::ivec2 high, bool polarization) {
    SeenLight seen;
    low = glm::clamp(low, glm::ivec2(0), glm::ivec2(picture.width - 1, picture.height - 1));
    high = glm::clamp(high, low + 1, glm::ivec2(picture.width, picture.height));
    const double count = static_cast<double>(high.x - low.x) * (high.y - low.y);
    const std::array<Plane, 4> planes = {polarization ? Plane::s0 : Plane::unpolarized, Plane::s1, Plane::s2,
                                         Plane::s3};
    for (std::size_t j = 0; j < (polarization ? 4u : 1u); ++j) {
        glm::dvec3 sum(0.0), variance(0.0);
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                const std::size_t pixel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
                sum += glm::dvec3(picture.of(planes[j])[pixel]);
                variance += glm::dvec3(picture.variance_of(planes[j])[pixel]);
            }
        }
        for (std::size_t band = 0; band < band_count; ++band) {
            seen.stokes[band][j] = sum[static_cast<int>(band)] / count;
            seen.error[band][j] = std::sqrt(std::max(0.0, variance[static_cast<int>(band)])) / count;
        }
    }
    return seen;
}

std::optional<double> brewster_angle(const Material& material) {
    if (material.interface.kind != InterfaceKind::dielectric) return {};
    const glm::vec3 n = material.interface.n;
    return degrees(std::atan(static_cast<double>(n.x + n.y + n.z) / 3));
}

std::optional<SeenSurface> seen_surface(const Scene& scene, const Rays& rays, glm::vec3 eye, glm::vec3 direction) {
    const std::optional<Hit> hit = seen_hit(rays, eye, direction);
    if (!hit) return {};
    SeenSurface seen;
    const Chart& chart = scene.charts[hit->chart];
    seen.chart = hit->chart;
    seen.material = chart.material;
    seen.position = hit->position;
    seen.unit_coordinates = chart.unit_coordinates(hit->position);
    const double cosine = -static_cast<double>(glm::dot(direction, hit->shading_normal));
    seen.incidence_degrees = degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    seen.brewster_degrees = brewster_angle(scene.materials[chart.material]);
    return seen;
}

}  // namespace brewster
