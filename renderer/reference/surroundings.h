#pragma once
#include <optional>
#include <vector>

#include "scene/bsdf.h"
#include "scene/lamp_light.h"
#include "scene/rays.h"
#include "scene/vectors.h"

namespace brewster {

/// A surface as a path meets it.
struct Vertex {
    const PreparedMaterial* material = nullptr;
    Vector<double> position{};
    Vector<double> normal{}, shading_normal{};  ///< unit, on the side that was hit
    std::uint32_t chart = no_chart, triangle = no_triangle;
    bool inside = false;  ///< of a closed transparent body, whose skin was hit
    double distance = 0;
};

/// A scene made ready for following single paths. Constant, so any number of threads may ask.
class Surroundings {
  public:
    /// Keeps a reference to the scene.
    explicit Surroundings(const Scene& whole)
        : scene(whole), rays(whole), lamps(whole), materials(prepare_materials(whole.materials)) {}

    const Scene& scene;
    const Rays rays;
    const LampLights lamps;
    const std::vector<PreparedMaterial> materials;

    struct Met {
        bool escaped = false;          ///< met nothing
        std::optional<Vertex> vertex;  ///< none as well on a back that absorbs
    };

    /// The first surface that a ray meets; `leaving` is the surface it starts on.
    Met meet(const Vector<double>& origin, const Vector<double>& direction, std::uint32_t leaving) const;

    /// The same for the eye's own first segment, which passes through the backs of single-sided surfaces.
    Met look(const Vector<double>& origin, const Vector<double>& direction) const;

    /// Whether the way from a vertex to the light is free.
    bool reaches(const Vertex& from, const LampLight& light) const;

    /// Whether the camera at `eye` sees the vertex.
    bool seen_from(const Vector<double>& eye, const Vertex& vertex) const;

  private:
    Met met_by(const Hit& hit) const;
};

}  // namespace brewster
