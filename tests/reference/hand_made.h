#pragma once
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/units.h"
#include "scene/read_lamp.h"
#include "scene/surfaces.h"

namespace brewster {

/// Small scenes for tests, made without a file.
class HandMade {
  public:
    std::uint32_t add(const Material& material) {
        scene_->materials.push_back(material);
        return static_cast<std::uint32_t>(scene_->materials.size() - 1);
    }

    /// A convex outline, counter-clockwise seen from the front.
    void polygon(const std::string& name, const std::vector<glm::vec3>& outline, std::uint32_t material) {
        Part part{name, name, material, outline, {}, {}};
        for (std::uint32_t k = 2; k < outline.size(); ++k) part.triangles.push_back({0, k - 1, k});
        surfaces(part);
    }

    /// A square of this half side around `middle`, its front towards `normal`.
    void square(const std::string& name, const glm::dvec3& middle, const glm::dvec3& normal, double half,
                std::uint32_t material) {
        const glm::dvec3 other =
            std::abs(normal.x) < 0.5 * glm::length(normal) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 x = glm::normalize(glm::cross(other, normal)), y = glm::normalize(glm::cross(normal, x));
        const auto at = [&](double a, double b) { return glm::vec3(middle + half * (a * x + b * y)); };
        polygon(name, {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, material);
    }

    /// An axis-aligned box; `inward`: its fronts look in.
    void box(const std::string& name, glm::vec3 low, glm::vec3 high, bool inward, std::uint32_t material) {
        Part part{name, name, material, {}, {}, {}};
        for (unsigned c = 0; c < 8; ++c)
            part.vertices.emplace_back(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
        const std::uint32_t sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        for (const auto& s : sides) {
            part.triangles.push_back({s[0], s[1], s[2]});
            part.triangles.push_back({s[0], s[2], s[3]});
        }
        if (inward)
            for (auto& triangle : part.triangles) std::swap(triangle[1], triangle[2]);
        surfaces(part);
    }

    /// A sphere of 2 rings x rings facets with its corners on the sphere.
    void sphere(const std::string& name, glm::dvec3 middle, double radius, int rings, bool inward,
                std::uint32_t material) {
        Part part{name, name, material, {}, {}, {}};
        const int sectors = 2 * rings;
        for (int i = 0; i <= rings; ++i)
            for (int j = 0; j < sectors; ++j) {
                const double t = pi * i / rings, p = 2 * pi * j / sectors;
                part.vertices.emplace_back(
                    middle + radius * glm::dvec3(std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p)));
            }
        const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * sectors + j % sectors); };
        for (int i = 0; i < rings; ++i)
            for (int j = 0; j < sectors; ++j) {
                if (i > 0) part.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
                if (i + 1 < rings) part.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
            }
        if (inward)
            for (auto& triangle : part.triangles) std::swap(triangle[1], triangle[2]);
        surfaces(part);
    }

    void lamp(const Lamp& lamp) { scene_->lamps.push_back(lamp); }

    /// The scene with its lamps completed; only once.
    std::shared_ptr<const Scene> finish() {
        for (const glm::vec3& v : scene_->vertices) {
            scene_->low = glm::min(scene_->low, v);
            scene_->high = glm::max(scene_->high, v);
        }
        complete_lamps(*scene_);
        return scene_;
    }

  private:
    void surfaces(const Part& part) { add_surfaces(*scene_, part); }

    std::shared_ptr<Scene> scene_ = std::make_shared<Scene>();
};

inline Material emitter(glm::vec3 radiance, glm::vec3 albedo = glm::vec3(0.0f)) {
    Material material;
    material.name = "emitter";
    material.albedo = albedo;
    material.emission = radiance;
    return material;
}

inline Material grey(float albedo) {
    Material material;
    material.name = "grey";
    material.albedo = glm::vec3(albedo);
    return material;
}

/// A sun of 4 lux that falls at 45 degrees on a floor z = const; of a disc of that radius.
inline Lamp slanting_sun(float angular_radius = 0) {
    Lamp sun;
    sun.kind = LampKind::sun;
    sun.intensity = glm::vec3(4.0f);
    sun.direction = glm::vec3(glm::normalize(glm::dvec3(1, 0, -1)));
    sun.angular_radius = angular_radius;
    return sun;
}

/// A spot of 3 cd, 2 m above the origin.
inline Lamp spot_above() {
    Lamp spot;
    spot.kind = LampKind::spot;
    spot.position = {0, 0, 2};
    spot.intensity = glm::vec3(3.0f);
    spot.cos_inner = 0.9f;
    spot.cos_outer = 0.5f;
    spot.power = spot_power(spot.intensity, spot.cos_inner, spot.cos_outer);
    return spot;
}

inline Camera looking(glm::dvec3 from, glm::dvec3 to, double vertical_degrees) {
    Camera camera;
    camera.name = "test";
    camera.position = glm::vec3(from);
    const glm::dvec3 forward = glm::normalize(to - from);
    const glm::dvec3 other = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    camera.forward = glm::vec3(forward);
    camera.up = glm::vec3(glm::normalize(other - glm::dot(other, forward) * forward));
    camera.vertical_field_of_view = static_cast<float>(radians(vertical_degrees));
    return camera;
}

}  // namespace brewster
