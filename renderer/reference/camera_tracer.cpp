#include "reference/camera_tracer.h"

#include "base/threads.h"
#include "reference/eye_chain.h"
#include "reference/path_random.h"

namespace brewster {
namespace {

constexpr std::size_t bands = band_count;
constexpr std::uint32_t bounce_limit = 1u << 14;  // none gets that far: roulette begins below
constexpr std::uint32_t bounces_before_roulette = 4;
constexpr int tile = 16;  // pixels

/// Power heuristic: the share of the technique that drew the direction.
double share(double own, double other) {
    return own * own / (own * own + other * other);
}

/// An eye path under way.
template <int components>
struct EyePath {
    EyeChain<components> chain;
    EyePathClass path_class;
    Vector<double> origin, direction, axis;  // of the segment under way; the axis belongs to light that comes along it
    std::uint32_t leaving = no_triangle;
    double pdf = 0;      // of the direction, 1/sr
    bool sharp = true;   // no lamp sample could have found the direction
    PixelStokes seen{};  // so far

    template <class Light>
    void see(std::size_t band, const Light& light) {
        const Stokes<double, components> arrived = chain.seen(band, light);
        for (int j = 0; j < components; ++j) seen[band][j] += arrived[j];
    }
};

/// Light of a sampled lamp by way of one lobe.
template <int components>
void add_lobe(EyePath<components>& path, const LobeValue<double, bands>& lobe, const LampLight& light, const Lamp& lamp,
              double cosine) {
    const Vector<double> light_in = -light.direction, light_out = -path.direction;
    const double weight = light.pdf > 0 ? share(light.pdf, lobe.pdf) / light.pdf : 1 / light.choice;
    Stokes<double, components> state = lamp_state<components>(lamp);
    FrameRotation<double> turn;
    if constexpr (components > 1) {
        if (lamp.polarization != glm::vec3(0.0f))
            state = rotate(rotation_between(light_in, lamp_axis(lamp, light_in), lobe.axis_in), state);
        turn = rotation_between(light_out, lobe.axis_out, path.axis);
    }
    for (std::size_t band = 0; band < bands; ++band)
        path.see(band,
                 (weight * cosine * light.radiance[static_cast<int>(band)]) * rotate(turn, lobe.value[band] * state));
}

template <int components>
void add_lamps(EyePath<components>& path, const Surroundings& surroundings, PathClasses classes, const Vertex& vertex,
               const std::array<double, 3>& numbers) {
    const bool base = vertex.material->diffuse() && contains(classes, path.path_class.with(Event::base));
    const bool gloss = vertex.material->rough() && contains(classes, path.path_class.with(Event::gloss));
    if (!base && !gloss) return;
    const auto light = surroundings.lamps.sample(vertex.position, numbers[0], numbers[1], numbers[2]);
    if (!light) return;
    const double cosine = dot(light->direction, vertex.shading_normal);
    if (cosine <= 0 || dot(light->direction, vertex.normal) <= 0) return;
    const auto value = evaluate_at<Use::eye>(vertex, -light->direction, -path.direction);
    const auto dark = [](const LobeValue<double, bands>& lobe) { return bsdf_detail::band_mean(lobe.value) <= 0; };
    if ((!base || dark(value.base)) && (!gloss || dark(value.gloss))) return;
    if (!surroundings.reaches(vertex, *light)) return;
    const Lamp& lamp = surroundings.scene.lamps[light->lamp];
    if (base) add_lobe(path, value.base, *light, lamp, cosine);
    if (gloss) add_lobe(path, value.gloss, *light, lamp, cosine);
}

/// Light of a lamp that the path has run into.
template <int components>
void add_emission(EyePath<components>& path, const Surroundings& surroundings, const Vertex& vertex) {
    double weight = 1;
    if (!path.sharp) {
        const Vector<double> way = vertex.position - path.origin;
        const double distance = std::sqrt(dot(way, way));
        weight = share(path.pdf, surroundings.lamps.pdf_of_area(vertex.chart, vertex.triangle, path.origin,
                                                                vertex.normal, path.direction, distance));
    }
    const glm::dvec3 radiance(vertex.material->emission);
    for (std::size_t band = 0; band < bands; ++band)
        path.see(band, unpolarized<components>(weight * radiance[static_cast<int>(band)]));
}

template <int components>
void add_discs(EyePath<components>& path, const Surroundings& surroundings) {
    surroundings.lamps.discs_seen(path.direction, [&](const LampLight& light) {
        const Lamp& lamp = surroundings.scene.lamps[light.lamp];
        const Vector<double> light_in = -path.direction;
        const double weight = path.sharp ? 1 : share(path.pdf, light.pdf);
        const auto state =
            rotate(rotation_between(light_in, lamp_axis(lamp, light_in), path.axis), lamp_state<components>(lamp));
        for (std::size_t band = 0; band < bands; ++band)
            path.see(band, (weight * light.radiance[static_cast<int>(band)]) * state);
    });
}

/// Goes on by one lobe; false where the path ends.
template <int components>
bool go_on(EyePath<components>& path, const Vertex& vertex, const BounceNumbers& numbers, PathClasses classes,
           bool roulette) {
    const auto sample = sample_at<Use::eye>(vertex, -path.direction, path.axis, numbers.scatter);
    if (!sample.alive) return false;
    // A shading normal can point a ray to the wrong side of the facet; it is absorbed there.
    if ((dot(sample.direction, vertex.normal) > 0) == sample.refracted) return false;
    path.path_class.add(event_of(vertex, sample));
    if (!path.path_class.can_end_in(classes)) return false;
    path.chain.prepend(sample.weight, sample.turn);
    path.axis = sample.axis;
    path.direction = sample.direction;
    path.origin = vertex.position;
    path.leaving = vertex.triangle;
    path.pdf = sample.pdf;
    path.sharp = sample.sharp;
    const double left = path.chain.largest();
    if (!(left > 0)) return false;
    if (roulette && left < 1) {
        if (numbers.roulette >= left) return false;
        path.chain.scale(1 / left);
    }
    return true;
}

}  // namespace

CameraTracer::CameraTracer(const Surroundings& surroundings, const Camera& camera, int width, int height,
                           const TracerSettings& settings)
    : surroundings_(surroundings), camera_(camera), settings_(settings), sums_(width, height) {}

template <int components>
PixelStokes CameraTracer::follow(int column, int row, std::uint64_t index) const {
    const auto pixel = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(sums_.width()) +
                       static_cast<std::uint64_t>(column);
    const PathRandom random(settings_.seed, (index << 28) + pixel, PathRandom::Kind::eye);
    const auto place = random.draw(0, 0);
    EyePath<components> path;
    path.origin = vector_of(camera_.position);
    path.direction =
        normalized(vector_of(ray_direction(camera_, sums_.width(), sums_.height(),
                                           static_cast<float>(column + place[0]), static_cast<float>(row + place[1]))));
    path.axis = normalized(cross(path.direction, vector_of(camera_.up)));
    Surroundings::Met met = surroundings_.look(path.origin, path.direction);
    for (std::uint32_t bounce = 1; bounce < bounce_limit; ++bounce) {
        const bool wanted = contains(settings_.classes, path.path_class.value());
        if (!met.vertex) {
            if (met.escaped && wanted) add_discs(path, surroundings_);
            break;
        }
        const Vertex& vertex = *met.vertex;
        if (wanted) add_emission(path, surroundings_, vertex);
        const BounceNumbers numbers(random, bounce, vertex.material->rough());
        if (!vertex.material->sharp() && surroundings_.lamps.any())
            add_lamps(path, surroundings_, settings_.classes, vertex, numbers.lamp);
        if (!go_on(path, vertex, numbers, settings_.classes, bounce >= bounces_before_roulette)) break;
        met = surroundings_.meet(path.origin, path.direction, path.leaving);
    }
    return path.seen;
}

PixelStokes CameraTracer::sample(int column, int row, std::uint64_t index) const {
    return settings_.polarized ? follow<4>(column, row, index) : follow<1>(column, row, index);
}

void CameraTracer::add_samples(std::uint64_t count, unsigned threads) {
    const int columns = (sums_.width() + tile - 1) / tile, rows = (sums_.height() + tile - 1) / tile;
    on_threads(columns * rows, threads, [&](int t, unsigned) {
        const int left = t % columns * tile, top = t / columns * tile;
        for (int row = top; row < std::min(top + tile, sums_.height()); ++row)
            for (int column = left; column < std::min(left + tile, sums_.width()); ++column)
                for (std::uint64_t index = samples_; index < samples_ + count; ++index)
                    sums_.add(static_cast<std::size_t>(row) * static_cast<std::size_t>(sums_.width()) +
                                  static_cast<std::size_t>(column),
                              sample(column, row, index));
    });
    samples_ += count;
}

}  // namespace brewster
