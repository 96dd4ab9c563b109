#pragma once
#include <optional>
#include <vector>

#include "optics/stokes.h"
#include "optics/vector.h"
#include "scene/landing.h"
#include "scene/scene.h"
#include "scene/spherical_triangle.h"

namespace brewster {

/// Light of a lamp at a point, before anything stands in its way.
struct LampLight {
    std::uint32_t lamp = 0, triangle = no_triangle;  ///< of an area lamp
    Vector<double> direction{};                      ///< unit, from the point to the lamp
    double distance = 0;                             ///< metres; infinite for a sun
    glm::dvec3 radiance{0.0};  ///< per band; for a lamp without extent its irradiance across the beam
    double pdf = 0;            ///< density of `direction`, 1/sr, the lamp's choice included; a lamp without extent: 0
    double choice = 1;         ///< probability of the lamp's choice
};

/// Lamps seen from points of the scene: the other end of LampSampler. Constant, so any number of threads may ask.
class LampLights {
  public:
    explicit LampLights(const Scene& scene);  ///< keeps a reference to the scene

    bool any() const { return !cumulative_.empty(); }

    /// One lamp by its power and a direction towards it, from three numbers in [0, 1): area lamps by area, but near
    /// triangles by solid angle, or the light of what touches a lamp would vary without bound; suns by their disc. None
    /// where the point is behind the lamp or outside its cone.
    std::optional<LampLight> sample(const Vector<double>& point, double choice, double u, double v) const;

    /// The same, where u chooses the lamp too and goes on with what the choice leaves of it: evenly spread pairs (u, v)
    /// then are evenly spread over all lamps.
    std::optional<LampLight> sample(const Vector<double>& point, double u, double v) const;

    /// The density with which `sample` at `point` finds the place of an area lamp that lies in `direction` at this
    /// distance, on this triangle, 1/sr. `normal`: unit, of the lamp there. Zero if the chart is no lamp or turns its back.
    double pdf_of_area(std::uint32_t chart, std::uint32_t triangle, const Vector<double>& point,
                       const Vector<double>& normal, const Vector<double>& direction, double distance) const;

    /// The suns whose disc a ray that leaves the scene runs into.
    template <class Visit>
    void discs_seen(const Vector<double>& direction, Visit visit) const {
        for (const std::uint32_t lamp : discs_)
            if (const auto light = disc_seen(lamp, direction)) visit(*light);
    }

  private:
    struct Facet {
        double before = 0, share = 1;  // of the lamp's area, before this triangle and with it; ends in 1
        TriangleShape<double> shape;
        Vector<double> normal;  // unit, on the side that glows
        Vector<double> centre;
        double near = 0;  // squared distance from the centre below which it may be sampled by solid angle

        bool is_near(const Vector<double>& point) const {
            const Vector<double> way = point - centre;
            return dot(way, way) < near;
        }
        std::optional<SphericalTriangle> seen_from(const Vector<double>& point) const;
    };
    std::vector<Facet> facets_of(const Lamp& lamp) const;
    static bool sample_near(const Facet& facet, const Vector<double>& point, double u, double v, LampLight& light);
    std::optional<LampLight> sample_lamp(std::size_t lamp, const Vector<double>& point, double u, double v) const;
    std::optional<LampLight> disc_seen(std::uint32_t lamp, const Vector<double>& direction) const;

    const Scene& scene_;
    std::vector<double> cumulative_;          // per lamp: share of power up to and with each, ends in 1
    std::vector<double> choice_;              // per lamp
    std::vector<std::vector<Facet>> facets_;  // per lamp
    std::vector<std::uint32_t> lamp_of_chart_, discs_;
};

/// Relative to the intensity on axis, KHR_lights_punctual: ((cos - cos outer)/(cos inner - cos outer))^2 between the
/// cones of a spot; 1 for all others. `direction`: unit, the way the light travels.
double falloff(const Lamp& lamp, const Vector<double>& direction);

/// The x axis that the lamp's polarization refers to for light that travels in `direction`.
Vector<double> lamp_axis(const Lamp& lamp, const Vector<double>& direction);

/// State of the lamp's light for S0 = 1, in the frame of lamp_axis.
template <int components>
Stokes<double, components> lamp_state(const Lamp& lamp) {
    const glm::dvec3 s(lamp.polarization);
    return stokes_of<components>(1.0, s.x, s.y, s.z);
}

}  // namespace brewster
