#include "transport/emission.h"

#include <algorithm>
#include <cmath>

#include "base/philox.h"

namespace brewster {
namespace {

// Where a photon of a sun or of a point flies is said by two of its numbers. An area lamp takes all four: directions that
// are useful from here are useless from there, and a guess from few photons would only add noise.
std::vector<bool> guided_lamps(const Scene& scene) {
    std::vector<bool> guided;
    for (const Lamp& lamp : scene.lamps) guided.push_back(lamp.kind != LampKind::area);
    return guided;
}

}  // namespace

PhotonEmission::PhotonEmission(const Scene& scene, std::uint64_t seed)
    : sampler_(scene), guide_(guided_lamps(scene)), seed_(seed) {
    for (const Lamp& lamp : scene.lamps) mean_power_ += static_cast<double>(lamp.mean_power());
    double sum = 0;
    for (const Lamp& lamp : scene.lamps) {
        const double power = static_cast<double>(lamp.mean_power());
        sum += power;
        cumulative_.push_back(mean_power_ > 0 ? static_cast<std::uint64_t>(std::llround(sum / mean_power_ * 0x1p32))
                                              : 0);
        const glm::vec3 weight = power > 0 ? lamp.power / lamp.mean_power() : glm::vec3(0);
        weights_.push_back({{weight.x, weight.y, weight.z, lamp.kind == LampKind::sun ? 1.0f : 0.0f}});
        polarized_ = polarized_ || lamp.polarization != glm::vec3(0);
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

std::uint32_t PhotonEmission::lamp_of(std::uint32_t word) const {
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), std::uint64_t{word});
    return static_cast<std::uint32_t>(found - cumulative_.begin());
}

EmittedPhoton<float> PhotonEmission::sample(std::uint64_t photon) const {
    std::array<std::uint32_t, 4> words;
    for (unsigned d = 0; d < 4; ++d) words[d] = sobol_word(photon, d + 1);
    return sample_by<float>(lamp_of(sobol_word(photon, 0)), words);
}

EmittedPhoton<FloatLanes> PhotonEmission::sample_lanes(std::uint64_t first) const {
    const CountLanes photon = counted_from(first);
    WordLanes lamp(0u);
    if (cumulative_.size() > 1) {
        std::array<std::uint32_t, lane_count> choice;
        store(sobol_words(photon.low, photon.high, 0), choice.data());
        for (std::uint32_t& word : choice) word = lamp_of(word);
        lamp = load_words(choice.data());
    }
    std::array<WordLanes, 4> words;
    for (unsigned d = 0; d < 4; ++d) words[d] = sobol_words(photon.low, photon.high, d + 1);
    return sample_by<FloatLanes>(lamp, words);
}

namespace {

// Halved words as numbers in [0, 1).
template <class Real>
Real number_below_one(const Word<Real>& word) {
    return min(constant<Real>(0x1p-31) * number_of(word >> 1), constant<Real>(0x1.fffffep-1));
}

}  // namespace

// A sun is guided by where its photons start, a point by where they go.
template <class Real>
EmittedPhoton<Real> PhotonEmission::sample_by(const Word<Real>& lamp, const std::array<Word<Real>, 4>& words) const {
    const auto of_lamp = row_at(weights_, lamp);
    const auto sun = of_lamp[3] > 0;
    const EmissionGuide::Start<Real> guided =
        guide_.warp<Real>(lamp, select(sun, words[0], words[2]), select(sun, words[1], words[3]));
    const auto number = [&](std::size_t d) { return number_below_one<Real>(words[d]); };
    EmittedPhoton<Real> emitted;
    emitted.start = sampler_.start<Real>(lamp, {select(sun, guided.x, number(0)), select(sun, guided.y, number(1)),
                                                select(sun, number(2), guided.x), select(sun, number(3), guided.y)});
    for (std::size_t band = 0; band < band_count; ++band) emitted.weight[band] = guided.weight * of_lamp[band];
    emitted.scale = guided.weight;
    emitted.lamp = lamp;
    emitted.guide_cell = guided.cell;
    return emitted;
}

}  // namespace brewster
