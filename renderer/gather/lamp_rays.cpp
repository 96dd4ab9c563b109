#include "gather/lamp_rays.h"

#include <algorithm>
#include <cmath>

#include "scene/landing.h"
#include "scene/vectors.h"

namespace brewster {
namespace {

/// Relative; positions are floats, and hits are pulled 1e-6 of a chart's size inside its edges.
constexpr float same_distance = 1e-4f;

template <int components>
void add_lamp_light(const LampSamples& lamps, LevelLight& light, std::uint32_t i) {
    for (std::size_t row = 0; row < 3 * components; ++row) light.stokes[row][i] += lamps.stokes[row][i];
    if (components > 1)
        for (std::size_t band = 0; band < band_count; ++band) light.unpolarized[band][i] += lamps.unpolarized[band][i];
}

}  // namespace

template <int components>
void LampRays::light(const EyeScene& scene, const BatchNumbers& numbers, std::uint32_t vertex, Level& level) {
    rays_.clear();
    shadowed_.clear();
    for (const Group& group : level.groups) {
        const PreparedMaterial& material = scene.materials[group.material];
        if (material.sharp()) continue;
        numbers.draw(level, group, lamp_dimension(vertex), u_, v_);
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            const bool wanted =
                (material.diffuse() && level.reads_direct[i] == 0) || (material.rough() && !level.ends_in_bins(i));
            if (!wanted || !sample(scene, level, i)) take_none(i);
        }
        over(group, [&]<class Real>(std::uint32_t i) {
            light_by_lamps<components, Real>(material, scene.coloured, scene.polarized_lamps, level, lamps_, i);
        });
        for (std::uint32_t i = group.first; i < group.end; ++i) {
            float brightest = 0;
            for (std::size_t band = 0; band < band_count; ++band)
                brightest = std::max(brightest, lamps_.unpolarized[band][i]);
            if (!(brightest > 0)) continue;
            rays_.push_back({eye_coordinates(load_vector<float>(level.position, i)),
                             eye_coordinates(load_vector<float>(lamps_.direction, i)), level.triangle[i]});
            shadowed_.push_back(i);
        }
    }
    hits_.resize(rays_.size());
    scene.rays.meet(rays_, hits_);
    for (std::size_t k = 0; k < shadowed_.size(); ++k)
        if (reaches(scene, rays_[k], hits_[k], shadowed_[k]))
            add_lamp_light<components>(lamps_, level.light, shadowed_[k]);
}

template void LampRays::light<1>(const EyeScene&, const BatchNumbers&, std::uint32_t, Level&);
template void LampRays::light<4>(const EyeScene&, const BatchNumbers&, std::uint32_t, Level&);

void LampRays::take_none(std::uint32_t i) {
    store_vector(Vector<float>{0, 0, 1}, lamps_.direction, i);
    for (auto& row : lamps_.radiance) row[i] = 0;
    lamps_.pdf[i] = 0;
    store_vector(Vector<float>{0, 0, 0}, lamps_.state, i);
    store_vector(Vector<float>{1, 0, 0}, lamps_.axis, i);
}

// False where the lamp stands below the surface or sends nothing there.
bool LampRays::sample(const EyeScene& scene, const Level& level, std::uint32_t i) {
    const auto light = scene.lamps.sample(double_vector(load_vector<float>(level.position, i)),
                                          static_cast<double>(u_[i]), static_cast<double>(v_[i]));
    if (!light) return false;
    const Vector<float> direction = single_vector(light->direction);
    if (!(dot(direction, load_vector<float>(level.normal, i)) > 0) ||
        !(dot(direction, load_vector<float>(level.shading_normal, i)) > 0))
        return false;
    store_vector(direction, lamps_.direction, i);
    const double density = light->pdf > 0 ? light->pdf : light->choice;
    for (std::size_t band = 0; band < band_count; ++band)
        lamps_.radiance[band][i] = static_cast<float>(light->radiance[static_cast<int>(band)] / density);
    lamps_.pdf[i] = static_cast<float>(light->pdf);
    lamps_.distance[i] = static_cast<float>(light->distance);
    lamps_.lamp[i] = light->lamp;
    if (scene.polarized_lamps) {
        const Lamp& lamp = scene.scene.lamps[light->lamp];
        store_vector(eye_vector(lamp.polarization), lamps_.state, i);
        store_vector(single_vector(lamp_axis(lamp, -light->direction)), lamps_.axis, i);
    }
    return true;
}

// Whether a shadow ray that met `hit` has found its lamp.
bool LampRays::reaches(const EyeScene& scene, const Ray& ray, const TriangleHit& hit, std::uint32_t i) const {
    const Lamp& lamp = scene.scene.lamps[lamps_.lamp[i]];
    if (!hit.met()) return lamp.kind != LampKind::area;
    const float distance = lamps_.distance[i];
    if (lamp.kind != LampKind::area) return hit.distance > distance;
    const LandingTriangle& triangle = scene.rays.landing_table().triangles[hit.triangle];
    const bool from_front = is_met_in_front(eye_vector(triangle.normal), eye_vector(ray.direction));
    return triangle.chart(from_front) == lamp.chart &&
           std::abs(hit.distance - distance) < same_distance * (distance + hit.distance);
}

}  // namespace brewster
