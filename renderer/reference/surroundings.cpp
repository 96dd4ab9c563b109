#include "reference/surroundings.h"

#include <cmath>

#include "scene/albedo.h"
#include "scene/filter_axis.h"

namespace brewster {
namespace {

/// Relative; positions are floats, and hits are pulled 1e-6 of a chart's size inside its edges.
constexpr double same_distance = 1e-4;

Hit first_hit(const Rays& rays, const Ray& ray) {
    Hit hit;
    rays.intersect(std::span(&ray, 1), std::span(&hit, 1));
    return hit;
}

}  // namespace

Surroundings::Met Surroundings::met_by(const Hit& hit) const {
    if (hit.escaped()) return {true, {}};
    if (hit.chart == no_chart) return {};
    const Chart& chart = scene.charts[hit.chart];
    Vertex vertex;
    vertex.material = &materials[chart.material];
    vertex.position = vector_of(hit.position);
    vertex.normal = normalized(vector_of(hit.normal));
    vertex.shading_normal = normalized(vector_of(hit.shading_normal));
    vertex.chart = hit.chart;
    vertex.triangle = hit.triangle;
    vertex.inside = vertex.material->base == Base::transparent && !vertex.material->thin &&
                    hit.chart == scene.triangles[hit.triangle].back_chart;
    if (vertex.material->filter != FilterKind::none) vertex.filter_axis = filter_axis(*vertex.material, chart);
    vertex.distance = static_cast<double>(hit.distance);
    vertex.tinted = vertex.material->diffuse() &&
                    (!scene.vertex_colors.empty() || scene.materials[chart.material].texture != no_texture);
    if (vertex.tinted) {
        const glm::vec4 tint = tint_at(scene, hit.triangle, hit.b1, hit.b2);
        for (std::size_t band = 0; band < band_count; ++band)
            vertex.tint[band] = vertex.material->tinted_base(band, static_cast<double>(tint[static_cast<int>(band)]));
    }
    return {false, vertex};
}

Surroundings::Met Surroundings::meet(const Vector<double>& origin, const Vector<double>& direction,
                                     std::uint32_t leaving) const {
    return met_by(first_hit(rays, {coordinates_of(origin), coordinates_of(direction), leaving}));
}

Surroundings::Met Surroundings::look(const Vector<double>& origin, const Vector<double>& direction) const {
    Ray ray{coordinates_of(origin), coordinates_of(direction), no_triangle};
    double passed = 0;
    constexpr int most_backs = 256;  // more than that, and it is one surface met again and again by rounding
    for (int back = 0; back < most_backs; ++back) {
        const Hit hit = first_hit(rays, ray);
        if (hit.escaped() || hit.chart != no_chart) {
            Met met = met_by(hit);
            if (met.vertex) met.vertex->distance += passed;
            return met;
        }
        passed += static_cast<double>(hit.distance);
        ray.origin = hit.position;
        ray.leaving = hit.triangle;
    }
    return {};
}

bool Surroundings::reaches(const Vertex& from, const LampLight& light) const {
    const Hit hit = first_hit(rays, {coordinates_of(from.position), coordinates_of(light.direction), from.triangle});
    if (hit.escaped()) return scene.lamps[light.lamp].kind != LampKind::area;
    const auto distance = static_cast<double>(hit.distance);
    if (scene.lamps[light.lamp].kind == LampKind::area)
        return hit.chart == scene.lamps[light.lamp].chart &&
               std::abs(distance - light.distance) < same_distance * (light.distance + distance);
    return distance > light.distance;
}

bool Surroundings::seen_from(const Vector<double>& eye, const Vertex& vertex,
                             const std::function<void(const Vertex& sheet)>& cross) const {
    const Vector<double> way = vertex.position - eye;
    const double distance = std::sqrt(dot(way, way));
    const Vector<double> direction = (1 / distance) * way;
    Met met = look(eye, direction);
    double passed = 0;
    while (met.vertex && met.vertex->material->crossed_straight()) {
        cross(*met.vertex);
        passed += met.vertex->distance;
        met = meet(met.vertex->position, direction, met.vertex->triangle);
    }
    return met.vertex && met.vertex->chart == vertex.chart &&
           std::abs(passed + met.vertex->distance - distance) < same_distance * distance;
}

}  // namespace brewster
