#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "reference/path_class.h"
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
    Vector<double> filter_axis{};  ///< of a filter sheet
    bool tinted = false;           ///< by a texture or the corners' colours: the base lobe is multiplied by `tint`
    std::array<double, band_count> tint = {1, 1, 1};
};

/// sample_bsdf at a vertex, where a path arrives from `towards`.
template <Use use>
ScatterSample<double, band_count> sample_at(const Vertex& vertex, const Vector<double>& towards,
                                            const Vector<double>& carried_axis, const ScatterNumbers<double>& numbers) {
    const SurfacePoint<double> point{towards, carried_axis, vertex.shading_normal, vertex.inside, vertex.filter_axis};
    auto sample = sample_bsdf<use, band_count>(*vertex.material, point, numbers);
    if (vertex.tinted && sample.base)
        for (std::size_t band = 0; band < band_count; ++band)
            sample.weight[band] = vertex.tint[band] * sample.weight[band];
    return sample;
}

/// evaluate_bsdf at a vertex.
template <Use use>
BsdfValue<double, band_count> evaluate_at(const Vertex& vertex, const Vector<double>& light_in,
                                          const Vector<double>& light_out) {
    auto value = evaluate_bsdf<use, band_count>(*vertex.material, light_in, light_out, vertex.shading_normal);
    if (vertex.tinted && value.has_base)
        for (std::size_t band = 0; band < band_count; ++band)
            value.base.value[band] = vertex.tint[band] * value.base.value[band];
    return value;
}

/// What the event of a sampled way on counts as.
template <class Sample>
Event event_of(const Vertex& vertex, const Sample& sample) {
    if (sample.base) return Event::base;
    if (!sample.sharp) return Event::gloss;
    return sample.refracted && vertex.material->crossed_straight() ? Event::straight : Event::sharp;
}

/// The way straight on through a pane or filter, for the eye that looks from `towards`; its weight is all that passes.
inline ScatterSample<double, band_count> straight_through(const Vertex& sheet, const Vector<double>& towards,
                                                          const Vector<double>& carried_axis) {
    ScatterNumbers<double> numbers;
    numbers.choice = 1;  // never the mirror
    auto sample = sample_at<Use::eye>(sheet, towards, carried_axis, numbers);
    if (sheet.material->filter == FilterKind::none)
        sample.weight.fill(
            thin_pane(dot(towards, sheet.normal), static_cast<double>(sheet.material->refracting_n)).transmission);
    return sample;
}

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

    /// Whether the camera at `eye` sees the vertex, through panes and filters as well: `cross` is called for each of
    /// these, from the eye on.
    bool seen_from(const Vector<double>& eye, const Vertex& vertex,
                   const std::function<void(const Vertex& sheet)>& cross) const;

  private:
    Met met_by(const Hit& hit) const;
};

}  // namespace brewster
