#pragma once
#include <array>

#include "base/philox.h"
#include "base/word_lanes.h"
#include "scene/bsdf.h"
#include "transport/context.h"

namespace brewster::transport {

/// Who asks for random numbers: the photon's index in two words, and its bounce.
template <class Real>
struct Key {
    Word<Real> photon_low, photon_high, bounce;
};

template <class Real>
std::array<Word<Real>, 4> random_words(std::uint64_t seed, const Key<Real>& key, std::uint32_t draw) {
    if constexpr (std::is_same_v<Real, float>)
        return philox(seed, std::uint64_t{key.photon_high} << 32 | key.photon_low, key.bounce, draw);
    else
        return philox(seed, key.photon_low, key.photon_high, key.bounce, draw);
}

/// This photon's number in one dimension of its Sobol sequence.
inline float sobol_number(const PhotonEmission& emission, const Key<float>& key, unsigned dimension) {
    return emission.sobol(std::uint64_t{key.photon_high} << 32 | key.photon_low, dimension);
}
inline FloatLanes sobol_number(const PhotonEmission& emission, const Key<FloatLanes>& key, unsigned dimension) {
    return emission.sobol(key.photon_low, key.photon_high, dimension);
}

/// Numbers of one event.
template <class Real>
struct EventNumbers {
    ScatterNumbers<Real> scatter;
    Real roulette{};
};

/// The first event of a photon goes on with its Sobol sequence.
template <class Real>
EventNumbers<Real> event_numbers(const TransportContext& context, const Key<Real>& key, const MaskOf<Real>& first,
                                 bool facets) {
    EventNumbers<Real> numbers;
    const std::array<Word<Real>, 4> words = random_words<Real>(context.seed, key, 0);
    numbers.roulette = unit_float(words[0]);
    ScatterNumbers<Real>& scatter = numbers.scatter;
    scatter.exit_u = unit_float(words[1]);
    scatter.exit_v = unit_float(words[2]);
    scatter.choice = unit_float(words[3]);
    if (any_of(first)) {
        constexpr unsigned next = PhotonEmission::dimensions;
        scatter.exit_u = select(first, sobol_number(context.emission, key, next), scatter.exit_u);
        scatter.exit_v = select(first, sobol_number(context.emission, key, next + 1), scatter.exit_v);
        scatter.choice = select(first, sobol_number(context.emission, key, next + 2), scatter.choice);
    }
    if (!facets) return numbers;
    const std::array<Word<Real>, 4> more = random_words<Real>(context.seed, key, 1);
    scatter.slope = unit_float(more[0]);
    scatter.facet_u = unit_float(more[1]);
    scatter.facet_v = unit_float(more[2]);
    scatter.facet_w = unit_float(more[3]);
    return numbers;
}

/// Numbers of the k-th direction of its lobe that an arrival files.
template <class Real>
ScatterNumbers<Real> lobe_numbers(const TransportContext& context, const Key<Real>& key, std::uint32_t k) {
    const std::array<Word<Real>, 4> words = random_words<Real>(context.seed, key, 2 + k);
    ScatterNumbers<Real> numbers;
    numbers.slope = unit_float(words[0]);
    numbers.facet_u = unit_float(words[1]);
    numbers.facet_v = unit_float(words[2]);
    numbers.facet_w = unit_float(words[3]);
    return numbers;
}

}  // namespace brewster::transport
