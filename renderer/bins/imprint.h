#pragma once
#include <cstddef>

#include "base/double_quad.h"
#include "bins/record.h"

namespace brewster {

/// Where an arrival goes in the records of its leaf.
struct ImprintPlace {
    int fields = 1, first_field = 0;
    int first_side = 0;         ///< of the fields behind the first
    std::uint32_t replica = 0;  ///< photon index mod 8
};

namespace imprint_detail {

inline DoubleQuad second_legendre(DoubleQuad x) {
    return everywhere(1.5) * x * x - everywhere(0.5);
}

/// What cell coordinates make of a weight: products of both, in the order of the records.
template <int D>
struct Factors;

template <>
struct Factors<2> {
    /// `x`: both coordinates, twice.
    explicit Factors(const float* at)
        : x(ordered<0, 1, 0, 1>(load_quad(at))), legendre(second_legendre(x)), sign(sign_of(x)) {}

    void add_estimate(DoubleQuad quanta, DoubleQuad w, Quanta* sums) const {
        add_quanta(sums, quanta, joined<3>(joined<1>(everywhere(1), ordered<0, 0, 1, 1>(x)), w));
    }
    void add_head(DoubleQuad quanta, DoubleQuad w, Quanta* sums) const {
        add_quanta(sums, quanta, joined<2>(x, legendre));
        add_quanta(sums + 4, quanta, joined<3>(joined<2>(sign, sign * ordered<1, 0, 3, 2>(sign)), w));
    }
    void add_side(DoubleQuad quanta, Quanta* sums) const { add_quanta(sums, quanta, joined<2>(legendre, sign)); }

    DoubleQuad x, legendre, sign;
};

template <>
struct Factors<4> {
    explicit Factors(const float* at) : x(load_quad(at)), legendre(second_legendre(x)), sign(sign_of(x)) {}

    void add_estimate(DoubleQuad quanta, DoubleQuad w, Quanta* sums) const {
        add_quanta(sums, quanta, joined<1>(everywhere(1), ordered<0, 0, 1, 2>(x)));
        add_two_quanta(sums + 4, quanta, joined<1>(ordered<3, 3, 3, 3>(x), w));
    }
    void add_head(DoubleQuad quanta, DoubleQuad w, Quanta* sums) const {
        add_quanta(sums, quanta, x);
        add_quanta(sums + 4, quanta, legendre);
        add_quanta(sums + 8, quanta, sign);
        add_quanta(sums + 12, quanta, ordered<0, 0, 0, 1>(sign) * ordered<1, 2, 3, 2>(sign));
        // The last number falls on the first replica and is zero.
        const DoubleQuad last = ordered<1, 2, 1, 2>(sign) * ordered<3, 3, 3, 3>(sign);
        add_quanta(sums + 16, quanta, joined<2>(last, joined<3>(w, everywhere(0))));
    }
    void add_side(DoubleQuad quanta, Quanta* sums) const {
        add_quanta(sums, quanta, legendre);
        add_quanta(sums + 4, quanta, sign);
    }

    DoubleQuad x, legendre, sign;
};

}  // namespace imprint_detail

/// Adds one arrival of light to both records of its leaf. `weights`: per field and band, in units of photon weight; the
/// first field is the main light, those behind it are side fields. `at`: cell coordinates of [-1, 1], four floats in
/// memory of which the first D count.
template <int D>
[[gnu::always_inline]] inline void add_imprint(const float* weights, const float* at, const ImprintPlace& place,
                                               int bands, Quanta* estimate, Quanta* test) {
    using Layout = RecordLayout<D>;
    const imprint_detail::Factors<D> factors(at);
    const float share = 1.0f / static_cast<float>(bands);
    estimate += place.first_field * bands * Layout::estimate_stride;
    Quanta* side = test + Layout::sides + place.first_side * Layout::side_stride;
    for (int field = 0; field < place.fields; ++field) {
        float sum = weights[0];
        for (int band = 1; band < bands; ++band) sum += weights[band];
        for (int band = 0; band < bands; ++band, ++weights, estimate += Layout::estimate_stride)
            factors.add_estimate(in_quanta(*weights), everywhere(static_cast<double>(*weights)), estimate);
        const float mean = sum * share;
        if (field > 0) {
            factors.add_side(in_quanta(mean), side);
            side += Layout::side_stride;
            continue;
        }
        factors.add_head(in_quanta(mean), everywhere(static_cast<double>(mean)), test);
        test[Layout::replicas + static_cast<int>(place.replica)] += to_quanta(mean);
    }
}

}  // namespace brewster
