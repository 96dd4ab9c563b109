#include "reference/light_tracer.h"

#include <algorithm>
#include <cmath>

#include "reference/eye_chain.h"
#include "reference/ordered_blocks.h"
#include "scene/shading_normal.h"

namespace brewster {
namespace {

constexpr std::uint64_t block = 4096;             // photons whose splats are kept together
constexpr std::uint32_t bounce_limit = 1u << 14;  // none gets that far: roulette

bool any_interface(const Surroundings& surroundings) {
    const auto& charts = surroundings.scene.charts;
    return std::any_of(charts.begin(), charts.end(), [&](const Chart& chart) {
        const PreparedMaterial& material = surroundings.materials[chart.material];
        return material.reflects() || material.base == Base::transparent;
    });
}

}  // namespace

LightTracer::LightTracer(const Surroundings& surroundings, const Camera& camera, int width, int height,
                         const TracerSettings& settings)
    : surroundings_(surroundings),
      camera_(camera),
      settings_(settings),
      source_(surroundings),
      sums_(width, height),
      picture_height_(2 * std::tan(0.5 * static_cast<double>(camera.vertical_field_of_view))) {
    const bool needs_interface = !contains(settings.classes, PathClass::bases);
    any_ = source_.any() && settings.classes != 0 && (!needs_interface || any_interface(surroundings));
}

template <int components>
void LightTracer::connect(const Photon<components>& photon, const LightPathClass& path_class, const Vertex& vertex,
                          std::vector<Splat>& splats) const {
    const bool base = vertex.material->diffuse() && contains(settings_.classes, path_class.with(Event::base));
    const bool gloss = vertex.material->rough() && contains(settings_.classes, path_class.with(Event::gloss));
    if (!base && !gloss) return;
    const Vector<double> eye = vector_of(camera_.position), way = eye - vertex.position;
    const double distance = std::sqrt(dot(way, way));
    if (!(distance > 0)) return;
    const Vector<double> out = (1 / distance) * way, forward = vector_of(camera_.forward);
    const double depth = -dot(out, forward);
    if (depth <= 0) return;
    const double side = picture_height_ / sums_.height();  // of a pixel at distance 1
    const double column = 0.5 * sums_.width() - dot(out, vector_of(camera_.right())) / (depth * side);
    const double row = 0.5 * sums_.height() + dot(out, vector_of(camera_.up)) / (depth * side);
    if (!(column >= 0 && column < sums_.width() && row >= 0 && row < sums_.height())) return;

    // Veach 1997, 5.3: f |i.N_s| |r.N_g| / |i.N_g| in place of f |r.N_g|.
    const double cos_out = dot(out, vertex.shading_normal);
    if (cos_out <= 0 || dot(out, vertex.normal) <= 0) return;
    const double correction = shading_normal_correction(photon.direction, out, vertex.shading_normal, vertex.normal);
    const auto value = evaluate_at<Use::light>(vertex, photon.direction, out);
    const auto dark = [](const LobeValue<double, band_count>& lobe) { return bsdf_detail::band_mean(lobe.value) <= 0; };
    if ((!base || dark(value.base)) && (!gloss || dark(value.gloss))) return;
    EyeChain<components> chain;  // of the sheets between
    Vector<double> axis = normalized(cross(-out, vector_of(camera_.up)));
    const bool seen = surroundings_.seen_from(eye, vertex, [&](const Vertex& sheet) {
        const auto through = straight_through(sheet, out, axis);
        chain.prepend(through.weight, through.turn);
        axis = through.axis;
    });
    if (!seen) return;

    // Radiance of a pixel is the mean over its area A on the image plane of L dA, dA = dOmega / cos^3; and L dOmega of
    // a point is its intensity over the distance squared.
    const double scale = correction * cos_out / (distance * distance * depth * depth * depth * side * side);
    Splat splat{
        static_cast<std::size_t>(row) * static_cast<std::size_t>(sums_.width()) + static_cast<std::size_t>(column), {}};
    const auto add = [&](const LobeValue<double, band_count>& lobe) {
        const auto in = rotation_between(photon.direction, photon.axis, lobe.axis_in);
        const auto leave = rotation_between(out, lobe.axis_out, axis);
        for (std::size_t band = 0; band < band_count; ++band) {
            const auto arrived = chain.seen(band, rotate(leave, lobe.value[band] * rotate(in, photon.light[band])));
            for (int j = 0; j < components; ++j) splat.light[band][j] += scale * arrived[j];
        }
    };
    if (base) add(value.base);
    if (gloss) add(value.gloss);
    splats.push_back(splat);
}

template <int components>
void LightTracer::follow(std::uint64_t index, std::vector<Splat>& splats) const {
    const PathRandom random(settings_.seed, index, PathRandom::Kind::light);
    Photon<components> photon = source_.emit<components>(random);
    const Lamp& lamp = surroundings_.scene.lamps[photon.lamp];
    LightPathClass path_class(lamp.kind != LampKind::area && !(lamp.angular_radius > 0));
    for (std::uint32_t bounce = 1; bounce < bounce_limit; ++bounce) {
        const auto met = surroundings_.meet(photon.position, photon.direction, photon.leaving);
        if (!met.vertex) return;
        if (!met.vertex->material->sharp()) connect(photon, path_class, *met.vertex, splats);
        const BounceNumbers numbers(random, bounce, met.vertex->material->rough());
        const auto event = scatter(photon, *met.vertex, numbers);
        if (!event || !survives_roulette(photon, numbers)) return;
        path_class.add(*event);
    }
}

void LightTracer::add_photons(std::uint64_t count, unsigned threads) {
    if (!any_) return;
    in_ordered_blocks(
        photons_, count, block, threads,
        [&](std::uint64_t first, std::uint64_t end) {
            std::vector<Splat> splats;
            for (std::uint64_t index = first; index < end; ++index)
                settings_.polarized ? follow<4>(index, splats) : follow<1>(index, splats);
            return splats;
        },
        [&](const std::vector<Splat>& splats) {
            for (const Splat& splat : splats) sums_.add(splat.pixel, splat.light);
        });
    photons_ += count;
}

}  // namespace brewster
