#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "base/fixed_point.h"
#include "base/units.h"

namespace brewster {

inline constexpr int replica_count = 8;  ///< photon index mod 8; their spread gives the error bars

/// Where a number stands in the two records of a leaf of one tree.
///
/// A field is a light that the tree tells from others, with a channel for each band. Over position (D = 2): direct light
/// in the polarized world, direct in the unpolarized one where that differs, then indirect light likewise. Over position
/// and direction (D = 4): S0, S1, .. of the polarized world, then S0 of the unpolarized one where that differs.
///
/// The estimate has for each channel sum w, sum w x_a of the cell coordinates x_a of [-1, 1], and sum w^2. The test has,
/// of the band mean of the main fields: per axis sum w x, sum w (3 x^2 - 1)/2, sum w sign x, per pair of axes
/// sum w sign x_a sign x_b, then sum w^2, and sum w of each replica; then of each side field, per axis,
/// sum w (3 x^2 - 1)/2 and sum w sign x: a split may be seen in them alone.
template <int D>
struct RecordLayout {
    static constexpr int estimate_stride = D + 2;
    static constexpr int pair_count = D * (D - 1) / 2;
    static constexpr int moments = 0;
    static constexpr int legendre = moments + D;
    static constexpr int signs = legendre + D;
    static constexpr int products = signs + D;
    static constexpr int squares = products + pair_count;
    static constexpr int replicas = squares + 1;
    static constexpr int sides = replicas + replica_count;
    static constexpr int side_stride = 2 * D;

    static constexpr int most_fields = 5;  ///< S0 .. S3 and the unpolarized S0

    int bands = band_count;  ///< 1: all light of the scene has one colour
    int fields = D == 2 ? 2 : 1;
    int side_fields = 0;                        ///< how many of the fields are beside the main ones
    std::array<int, most_fields> side_field{};  ///< which

    int channels() const { return bands * fields; }
    int estimate_size() const { return channels() * estimate_stride; }
    int test_size() const { return sides + side_fields * side_stride; }
    bool operator==(const RecordLayout&) const = default;
};

/// The fields of light that enters bases: how many worlds there are of the direct and of the indirect light, 1 where the
/// polarized and the unpolarized world are the same.
struct EntryFields {
    int bands = band_count;
    int direct_worlds = 1, indirect_worlds = 1;

    RecordLayout<2> layout() const {
        RecordLayout<2> layout{bands, direct_worlds + indirect_worlds, 0, {}};
        for (const int light : {0, 1})
            if (worlds(light) == 2) layout.side_field[static_cast<std::size_t>(layout.side_fields++)] = field(light, 1);
        return layout;
    }
    int worlds(int light) const { return light == 0 ? direct_worlds : indirect_worlds; }
    /// light: 0 direct, 1 indirect; world: 0 polarized, 1 unpolarized.
    int field(int light, int world) const {
        return (light == 0 ? 0 : direct_worlds) + (worlds(light) == 2 ? world : 0);
    }
    bool operator==(const EntryFields&) const = default;
};

/// The fields of gloss: components of the Stokes vector of the polarized world, then S0 of the unpolarized one where it
/// differs.
struct GlossFields {
    int bands = band_count;
    int components = 1;  ///< 1, 3 or 4; 1: both worlds are the same

    int worlds() const { return components > 1 ? 2 : 1; }
    int unpolarized_field() const { return components > 1 ? components : 0; }
    RecordLayout<4> layout() const {
        RecordLayout<4> layout{bands, components + worlds() - 1, 0, {}};
        for (int field = 1; field < layout.fields; ++field)
            layout.side_field[static_cast<std::size_t>(layout.side_fields++)] = field;
        return layout;
    }
    bool operator==(const GlossFields&) const = default;
};

/// Sums of one cell over everything that landed in it since it came to be.
struct CellSums {
    std::span<const Wide> estimate, test;
};

}  // namespace brewster
