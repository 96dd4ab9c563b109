#include "transport/emission.h"

#include <algorithm>
#include <cmath>

#include "base/philox.h"

namespace brewster {
namespace {

float below_one(double x) {
    return std::min(static_cast<float>(x), 0x1.fffffep-1f);
}

// Where a photon of a sun or of a point flies is said by two of its numbers. An area lamp takes all four: directions that
// are useful from here are useless from there, and a guess from few photons would only add noise.
std::vector<bool> guided_lamps(const Scene& scene) {
    std::vector<bool> guided;
    for (const Lamp& lamp : scene.lamps) guided.push_back(lamp.kind != LampKind::area);
    return guided;
}

}  // namespace

PhotonEmission::PhotonEmission(const Scene& scene, std::uint64_t seed)
    : scene_(scene), sampler_(scene), guide_(guided_lamps(scene)), seed_(seed) {
    for (const Lamp& lamp : scene.lamps) mean_power_ += static_cast<double>(lamp.mean_power());
    double sum = 0;
    for (const Lamp& lamp : scene.lamps) {
        const double power = static_cast<double>(lamp.mean_power());
        sum += power;
        cumulative_.push_back(mean_power_ > 0 ? static_cast<std::uint64_t>(std::llround(sum / mean_power_ * 0x1p32))
                                              : 0);
        weights_.push_back(power > 0 ? lamp.power / lamp.mean_power() : glm::vec3(0));
    }
    for (std::uint32_t replica = 0; replica < replica_count; ++replica)
        for (std::uint32_t d = 0; d < sobol_dimensions; ++d) scrambles_[replica][d] = scramble_of(seed, replica, d);
}

std::uint32_t PhotonEmission::sobol_word(std::uint64_t photon, unsigned dimension) const {
    const auto replica = static_cast<std::uint32_t>(photon % replica_count);
    const std::uint64_t index = photon / replica_count;
    // The sequence ends after 2^32 points; what follows is scrambled anew.
    const auto round = static_cast<std::uint32_t>(index >> 32);
    const std::uint32_t scramble =
        round == 0 ? scrambles_[replica][dimension] : scramble_of(seed_, replica + replica_count * round, dimension);
    return sobol_owen(static_cast<std::uint32_t>(index), dimension, scramble);
}

float PhotonEmission::sobol(std::uint64_t photon, unsigned dimension) const {
    return unit_float(sobol_word(photon, dimension));
}

WordLanes PhotonEmission::sobol_words(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const {
    if (any_of(!equal(photon_high >> 3, WordLanes(0u)))) {  // another round
        std::array<std::uint32_t, lane_count> low, high, words;
        store(photon_low, low.data());
        store(photon_high, high.data());
        for (std::size_t i = 0; i < lane_count; ++i)
            words[i] = sobol_word(std::uint64_t{high[i]} << 32 | low[i], dimension);
        return load_words(words.data());
    }
    static_assert(replica_count == 8);
    const WordLanes index = (photon_low >> 3) | (photon_high << 29);
    const WordLanes scramble =
        gather<1>(scrambles_[0].data() + dimension, (photon_low & WordLanes(7u)) * WordLanes(sobol_dimensions));
    return sobol_owen(index, dimension, scramble);
}

FloatLanes PhotonEmission::sobol(WordLanes photon_low, WordLanes photon_high, unsigned dimension) const {
    return unit_float(sobol_words(photon_low, photon_high, dimension));
}

EmittedPhoton PhotonEmission::sample(std::uint64_t photon) const {
    Words words;
    for (unsigned d = 0; d < dimensions; ++d) words[d] = sobol_word(photon, d);
    return sample_by(words);
}

void PhotonEmission::sample(std::uint64_t first, std::span<EmittedPhoton> photons) const {
    std::array<std::uint32_t, lane_count> low, high;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        low[lane] = static_cast<std::uint32_t>(first + lane);
        high[lane] = static_cast<std::uint32_t>((first + lane) >> 32);
    }
    std::array<std::array<std::uint32_t, lane_count>, dimensions> numbers;
    for (unsigned d = 0; d < dimensions; ++d)
        store(sobol_words(load_words(low.data()), load_words(high.data()), d), numbers[d].data());
    for (std::size_t lane = 0; lane < photons.size(); ++lane) {
        Words words;
        for (unsigned d = 0; d < dimensions; ++d) words[d] = numbers[d][lane];
        photons[lane] = sample_by(words);
    }
}

EmittedPhoton PhotonEmission::sample_by(const Words& words) const {
    const std::uint64_t choice = words[0];
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), choice);
    const auto lamp = static_cast<std::uint32_t>(found - cumulative_.begin());
    std::array<double, 4> numbers;
    for (unsigned d = 0; d < 4; ++d) numbers[d] = 0x1p-32 * words[d + 1];
    // A sun is guided by where its photons start, a point by where they go.
    const std::size_t guided_number = scene_.lamps[lamp].kind == LampKind::sun ? 0 : 2;
    const EmissionGuide::Start guided = guide_.warp(lamp, numbers[guided_number], numbers[guided_number + 1]);
    const Emission start = sampler_.emit(
        lamp, {below_one(numbers[0]), below_one(numbers[1]), below_one(numbers[2]), below_one(numbers[3])});
    EmittedPhoton emitted;
    emitted.scale = guided.weight;
    emitted.guide_cell = guided.cell;
    emitted.ray = {start.position, start.direction, start.leaving};
    emitted.weight = guided.weight * weights_[lamp];
    emitted.lamp = lamp;
    return emitted;
}

}  // namespace brewster
