#include "scene/lamp.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/units.h"
#include "scene/bounding_rectangle.h"
#include "scene/start_direction.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

constexpr float one_over_pi = static_cast<float>(1.0 / pi);

}  // namespace

glm::vec3 across(glm::vec3 axis) {
    const glm::vec3 size = glm::abs(axis);
    const glm::vec3 other = size.x <= size.y && size.x <= size.z ? glm::vec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::vec3(0, 1, 0)
                                                                 : glm::vec3(0, 0, 1);
    return glm::normalize(glm::cross(axis, other));
}

float sine_of_radius(const Lamp& sun) {
    return static_cast<float>(std::sin(static_cast<double>(sun.angular_radius)));
}

glm::vec3 point_power(glm::vec3 intensity) {
    return static_cast<float>(4.0 * pi) * intensity;
}

glm::vec3 spot_power(glm::vec3 intensity, float cos_inner, float cos_outer) {
    const SpotShares<float> shares = spot_shares(cos_inner, cos_outer);
    return static_cast<float>(2.0 * pi) * (shares.edge + shares.core) * intensity;
}

SunRectangle sun_rectangle(glm::vec3 low, glm::vec3 high, glm::vec3 direction, float angular_radius) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(direction));
    const glm::dvec3 x =
        glm::normalize(glm::dvec3(across(direction)) - along * glm::dot(glm::dvec3(across(direction)), along));
    const glm::dvec3 y = glm::cross(along, x);
    std::vector<glm::dvec2> points;
    double upstream = INFINITY, downstream = -INFINITY, largest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
        points.emplace_back(glm::dot(p, x), glm::dot(p, y));
        upstream = std::min(upstream, glm::dot(p, along));
        downstream = std::max(downstream, glm::dot(p, along));
        largest = std::max(largest, glm::length(p));
    }
    const BoundingRectangle box = smallest_rectangle(std::move(points));
    const glm::dvec3 u = box.axis.x * x + box.axis.y * y, v = -box.axis.y * x + box.axis.x * y;
    const double clearance = 0.01 * largest;
    const glm::dvec3 corner = box.corner.x * x + box.corner.y * y + (upstream - clearance) * along;
    const double margin = (downstream - upstream + clearance) * std::tan(static_cast<double>(angular_radius));
    const double half_length = 0.5 * box.length + margin, half_width = 0.5 * box.width + margin;
    SunRectangle rectangle;
    rectangle.half_u = glm::vec3(half_length * u);
    rectangle.half_v = glm::vec3(half_width * v);
    rectangle.centre = glm::vec3(corner + 0.5 * box.length * u + 0.5 * box.width * v);
    rectangle.area = static_cast<float>(4 * half_length * half_width);
    return rectangle;
}

float pdf_disc(const Lamp& sun, glm::vec3 direction) {
    const float sine = sine_of_radius(sun), cosine = glm::dot(sun.direction, direction);
    if (cosine < std::sqrt((1.0f - sine) * (1.0f + sine))) return 0.0f;
    return cosine * one_over_pi / (sine * sine);
}

glm::vec3 sample_cosine(glm::vec3 axis_u, glm::vec3 axis_v, glm::vec3 normal, float x, float y) {
    return glm_vector(
        turned_about(float_vector(axis_u), float_vector(axis_v), float_vector(normal), cosine_slant(x), y));
}

float pdf_cosine(glm::vec3 normal, glm::vec3 direction) {
    const float cosine = glm::dot(normal, direction);
    return cosine > 0.0f ? cosine * one_over_pi : 0.0f;
}

glm::vec3 sample_sphere(float x, float y) {
    return glm_vector(turned_about<float>({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, sphere_slant(x), y));
}

float pdf_sphere() {
    return 0.25f * one_over_pi;
}

float pdf_spot(const Lamp& spot, glm::vec3 direction) {
    const float cosine = glm::dot(spot.direction, direction);
    if (cosine <= spot.cos_outer) return 0.0f;
    const float ramp = cosine >= spot.cos_inner ? 1.0f : (cosine - spot.cos_outer) / (spot.cos_inner - spot.cos_outer);
    const SpotShares<float> shares = spot_shares(spot.cos_inner, spot.cos_outer);
    return ramp * ramp / (static_cast<float>(2.0 * pi) * (shares.edge + shares.core));
}

}  // namespace brewster
