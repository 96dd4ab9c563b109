#include "reference/light_path.h"

#include <algorithm>

#include "scene/shading_normal.h"

namespace brewster {
namespace {

constexpr double roulette_share = 0.25;  // of the weight at emission, below which the roulette begins

std::array<float, 4> floats_of(const std::array<double, 4>& numbers) {
    std::array<float, 4> x;
    for (std::size_t j = 0; j < 4; ++j) x[j] = std::min(static_cast<float>(numbers[j]), 0x1.fffffep-1f);
    return x;
}

}  // namespace

PhotonSource::PhotonSource(const Surroundings& surroundings)
    : surroundings_(surroundings), sampler_(surroundings.scene) {
    double total = 0, sum = 0;
    for (const Lamp& lamp : surroundings.scene.lamps) total += static_cast<double>(lamp.mean_power());
    if (!(total > 0)) return;
    for (const Lamp& lamp : surroundings.scene.lamps) {
        choice_.push_back(static_cast<double>(lamp.mean_power()) / total);
        cumulative_.push_back(sum += choice_.back());
    }
}

/// A sun with a disc: a direction of the disc, and the rectangle that belongs to it.
Emission PhotonSource::start_of_sun(const Lamp& lamp, const std::array<double, 4>& numbers, glm::dvec3& power) const {
    const Vector<double> middle = normalized(vector_of(lamp.direction));
    const double half = std::sin(0.5 * static_cast<double>(lamp.angular_radius));
    const double versine = numbers[2] * 2 * half * half, sine = std::sqrt(versine * (2 - versine));
    const Vector<double> x = axis_across(middle, middle), y = cross(middle, x);
    const Vector<double> direction = normalized((1 - versine) * middle + (sine * std::cos(2 * pi * numbers[3])) * x +
                                                (sine * std::sin(2 * pi * numbers[3])) * y);
    const Scene& scene = surroundings_.scene;
    const SunRectangle sun = sun_rectangle(scene.low, scene.high, coordinates_of(direction));
    // Radiance E/(pi sin^2) over the disc's solid angle 2 pi (1 - cos) = 4 pi half^2.
    const double full = std::sin(static_cast<double>(lamp.angular_radius));
    power = 4 * half * half / (full * full) * static_cast<double>(sun.area) * glm::dvec3(lamp.intensity);
    const auto place = floats_of(numbers);
    return {sun.centre + (2.0f * place[0] - 1.0f) * sun.half_u + (2.0f * place[1] - 1.0f) * sun.half_v,
            coordinates_of(direction), no_triangle};
}

template <int components>
Photon<components> PhotonSource::emit(const PathRandom& random) const {
    const auto chosen = random.draw(0, 0);
    const auto at = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, chosen[0]);
    const auto index = static_cast<std::size_t>(at - cumulative_.begin());
    const Lamp& lamp = surroundings_.scene.lamps[index];
    glm::dvec3 power(lamp.power);
    const bool disc = lamp.kind == LampKind::sun && lamp.angular_radius > 0;
    const Emission start = disc ? start_of_sun(lamp, random.draw(0, 1), power)
                                : sampler_.emit(static_cast<std::uint32_t>(index), floats_of(random.draw(0, 1)));
    Photon<components> photon;
    photon.position = vector_of(start.position);
    photon.direction = normalized(vector_of(start.direction));
    photon.axis = lamp_axis(lamp, photon.direction);
    photon.leaving = start.leaving;
    photon.lamp = static_cast<std::uint32_t>(index);
    for (std::size_t band = 0; band < band_count; ++band)
        photon.light[band] = (power[static_cast<int>(band)] / choice_[index]) * lamp_state<components>(lamp);
    photon.reference = photon.largest();
    return photon;
}

template <int components>
std::optional<Event> scatter(Photon<components>& photon, const Vertex& vertex, const BounceNumbers& numbers) {
    const auto sample = sample_at<Use::light>(vertex, -photon.direction, photon.axis, numbers.scatter);
    if (!sample.alive) return {};
    // A shading normal can point a photon to the wrong side of the facet; it is absorbed there.
    if ((dot(sample.direction, vertex.normal) > 0) == sample.refracted) return {};
    const double correction =
        shading_normal_correction(photon.direction, sample.direction, vertex.shading_normal, vertex.normal);
    for (std::size_t band = 0; band < band_count; ++band)
        photon.light[band] = correction * (sample.weight[band] * rotate(sample.turn, photon.light[band]));
    photon.position = vertex.position;
    photon.direction = sample.direction;
    photon.axis = sample.axis;
    photon.leaving = vertex.triangle;
    if (!(photon.largest() > 0)) return {};
    return event_of(vertex, sample);
}

template <int components>
bool survives_roulette(Photon<components>& photon, const BounceNumbers& numbers) {
    const double survival = photon.largest() / photon.reference;
    if (survival >= roulette_share) return true;
    if (numbers.roulette >= survival) return false;
    for (auto& band : photon.light) band = (1 / survival) * band;
    return true;
}

template Photon<1> PhotonSource::emit(const PathRandom&) const;
template Photon<4> PhotonSource::emit(const PathRandom&) const;
template std::optional<Event> scatter(Photon<1>&, const Vertex&, const BounceNumbers&);
template std::optional<Event> scatter(Photon<4>&, const Vertex&, const BounceNumbers&);
template bool survives_roulette(Photon<1>&, const BounceNumbers&);
template bool survives_roulette(Photon<4>&, const BounceNumbers&);

}  // namespace brewster
