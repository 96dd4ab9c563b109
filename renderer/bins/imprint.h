#pragma once
#include <array>
#include <cstddef>

#include "base/rows.h"
#include "bins/record.h"

namespace brewster {

/// What one arrival of light adds to the records of its leaf, in weights, for one photon or for a batch of lanes: the
/// numbers stand in the order of the records, so that whole runs of them are added at a time.
template <class Real, int D, int most_fields, int most_bands>
struct Imprint {
    static constexpr std::size_t estimate_at = 0;
    static constexpr std::size_t head_at =
        static_cast<std::size_t>(most_fields * most_bands * RecordLayout<D>::estimate_stride);
    static constexpr std::size_t head_size = RecordLayout<D>::replicas;  ///< of the test record, replicas come next
    static constexpr std::size_t sides_at = head_at + head_size;
    static constexpr std::size_t main_at = sides_at + static_cast<std::size_t>((most_fields - 1) * 2 * D);
    static constexpr std::size_t size = main_at + 1;

    std::array<Real, size> x;
};

/// `weights`: per field and band, in units of photon weight; the first field is the main light, those behind it are side
/// fields. `at`: cell coordinates of [-1, 1].
template <class Real, int D, int most_fields, int most_bands>
[[gnu::always_inline]] inline void make_imprint(const Real* weights, int fields, int bands,
                                                const std::array<Real, static_cast<std::size_t>(D)>& at,
                                                Imprint<Real, D, most_fields, most_bands>& imprint) {
    using Places = Imprint<Real, D, most_fields, most_bands>;
    constexpr auto dimensions = static_cast<std::size_t>(D);
    const int channels = fields * bands;
    Real* estimate = imprint.x.data();
    for (int channel = 0; channel < channels; ++channel) {
        const Real w = weights[channel];
        *estimate++ = w;
        for (std::size_t a = 0; a < dimensions; ++a) *estimate++ = w * at[a];
        *estimate++ = w * w;
    }

    const Real share(1.0f / static_cast<float>(bands));
    const auto band_mean = [&](int field) {
        Real sum = weights[field * bands];
        for (int band = 1; band < bands; ++band) sum = sum + weights[field * bands + band];
        return sum * share;
    };
    std::array<Real, dimensions> legendre;
    std::array<decltype(at[0] < 0), dimensions> negative;
    for (std::size_t a = 0; a < dimensions; ++a) {
        legendre[a] = constant<Real>(1.5) * at[a] * at[a] - constant<Real>(0.5);
        negative[a] = at[a] < 0;
    }
    const Real w = band_mean(0);
    Real* head = imprint.x.data() + Places::head_at;
    *head++ = w * w;
    for (std::size_t a = 0; a < dimensions; ++a) *head++ = w * at[a];
    for (std::size_t a = 0; a < dimensions; ++a) *head++ = w * legendre[a];
    for (std::size_t a = 0; a < dimensions; ++a) *head++ = select(negative[a], -w, w);
    for (std::size_t a = 0; a < dimensions; ++a)
        for (std::size_t b = a + 1; b < dimensions; ++b)
            *head++ = select((negative[a] && !negative[b]) || (negative[b] && !negative[a]), -w, w);
    imprint.x[Places::main_at] = w;

    Real* side = imprint.x.data() + Places::sides_at;
    for (int field = 1; field < fields; ++field) {
        const Real s = band_mean(field);
        for (std::size_t a = 0; a < dimensions; ++a) *side++ = s * legendre[a];
        for (std::size_t a = 0; a < dimensions; ++a) *side++ = select(negative[a], -s, s);
    }
}

/// Where an arrival goes in the records of its leaf.
struct ImprintPlace {
    int fields = 1, first_field = 0;
    int first_side = 0;         ///< of the fields behind the first
    std::uint32_t replica = 0;  ///< photon index mod 8
};

/// Adds the numbers of one photon, in a row of memory, to a leaf's records.
template <int D, int most_fields, int most_bands>
[[gnu::always_inline]] inline void add_imprint(const float* row, const ImprintPlace& place, int bands, Quanta* estimate,
                                               Quanta* test) {
    using Places = Imprint<float, D, most_fields, most_bands>;
    using Layout = RecordLayout<D>;
    const auto channels = static_cast<std::size_t>(place.fields * bands);
    add_quanta(estimate + place.first_field * bands * Layout::estimate_stride, row, channels * Layout::estimate_stride);
    add_quanta(test, row + Places::head_at, Places::head_size);
    test[Layout::replicas + static_cast<int>(place.replica)] += to_quanta(row[Places::main_at]);
    if (place.fields > 1)
        add_quanta(test + Layout::sides + place.first_side * Layout::side_stride, row + Places::sides_at,
                   static_cast<std::size_t>((place.fields - 1) * Layout::side_stride));
}

}  // namespace brewster
