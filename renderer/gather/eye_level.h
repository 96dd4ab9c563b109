#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/units.h"
#include "base/word_lanes.h"
#include "gather/eye_scene.h"
#include "optics/frame.h"
#include "optics/planar_mueller.h"

namespace brewster {

inline constexpr std::size_t eye_batch = 512;  ///< draws that go through the stages together
/// Rays at one depth: a draw's path parts once at most. A little more, so that rows do not all fall on the same few sets
/// of a cache.
inline constexpr std::size_t most_rays = 2 * eye_batch + 16;

/// Rough and sharp events on a path; then come the bins of gloss.
inline constexpr int most_rough_events = 3, most_sharp_events = 8;
/// At glass nothing comes then: light goes to and fro in a body of it, whose skin has no bins.
inline constexpr int most_events_of_glass = 32;

/// So many floats for each ray of a batch, structure of arrays.
template <std::size_t rows>
using Rows = std::array<std::array<float, most_rays>, rows>;

template <class Real>
Vector<Real> load_vector(const Rows<3>& rows, std::size_t i) {
    return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
template <class Real>
void store_vector(const Vector<Real>& v, Rows<3>& rows, std::size_t i) {
    store(v.x, &rows[0][i]);
    store(v.y, &rows[1][i]);
    store(v.z, &rows[2][i]);
}
/// Words of eight entries as a batch; one for a float.
template <class Real>
Word<Real> load_word(const std::uint32_t* from) {
    if constexpr (std::is_same_v<Real, FloatLanes>)
        return load_words(from);
    else
        return *from;
}
/// row[index] in each lane.
inline WordLanes entries_of(const std::uint32_t* row, WordLanes index) {
    return brewster::gather<1>(row, index);
}
inline std::uint32_t entries_of(const std::uint32_t* row, std::uint32_t index) {
    return row[index];
}
template <class Real, std::size_t size>
Real entries_of(const std::array<float, size>& row, const Word<Real>& index) {
    return floats_of(entries_of(reinterpret_cast<const std::uint32_t*>(row.data()), index));
}
inline Vector<float> eye_vector(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
inline glm::vec3 eye_coordinates(const Vector<float>& v) {
    return {v.x, v.y, v.z};
}

/// A ray under way from the eye, against the light.
struct Segment {
    Ray ray;
    Vector<float> axis{};      ///< the x axis of light that comes along the ray; unit, orthogonal to it
    float pdf = 0;             ///< of its direction by the lobe that sent it, 1/sr; 0: mirror, refraction or the camera
    float throughput = 1;      ///< at most this share of its light reaches the camera
    std::uint32_t draw = 0;    ///< in the batch
    std::uint32_t parent = 0;  ///< in the level before; at first the draw
    std::uint8_t way = 0;      ///< of the parent's: first or second
    std::uint8_t rough = 0, sharp = 0;  ///< events so far
    bool parted = false;                ///< the draw has another ray as well
    bool gathers = false;               ///< for a base whose direct light is known: sees no lamps, ends in the bins
};

/// Light along the rays of a level, cd/m2, both worlds, in the frames of the rays' axes; and standard errors that the
/// bins it was read from lend it.
struct LevelLight {
    Rows<12> stokes;                      ///< component * 3 + band; polarized world
    Rows<3> unpolarized;                  ///< S0 of the other world
    Rows<3> error;                        ///< of S0
    Rows<3> polarized_error;              ///< of each of S1, S2, S3
    Rows<3> unpolarized_error;            ///< of the other world's S0
    std::array<float, most_rays> coarse;  ///< band mean of the unpolarized world's light that came from bins of gloss

    void clear(std::size_t size);
};

/// Entries of one material and side, next to each other.
struct Group {
    std::uint32_t material = 0;
    bool inside = false;
    std::uint32_t first = 0, end = 0;
};

/// All rays of one depth, with what they have met and the light that comes along them. Those that have met a surface
/// stand in groups, the others (in the open, on a back that absorbs) behind the last group.
struct Level {
    std::uint32_t size = 0;
    std::vector<Group> groups;

    std::array<std::uint32_t, most_rays> parent, draw, chart, triangle, u, v;
    std::array<std::uint32_t, most_rays> parent_way;  ///< of the parent's rows of ways
    std::array<std::uint8_t, most_rays> sharp_events;
    std::array<float, most_rays> tolerance;      ///< of bins, as of the draw
    std::array<float, most_rays> wide_share;     ///< of draws that leave this gloss by the cosine as well; 0: none does
    std::array<std::uint8_t, most_rays> widely;  ///< 1 where this one does
    std::array<std::uint8_t, most_rays> gathers;  ///< 1 where one may, then where one does gather the indirect light
    std::array<float, most_rays> eagerness;  ///< to follow both ways at glass (Draw); 0 where the path may not part
    std::array<float, most_rays> rough_events, throughput;
    std::array<float, most_rays> reads_direct;  ///< 1 where the bins tell direct light, too; 0 where shadow rays do
    Rows<3> direction, axis, position, normal, shading_normal;
    Rows<3> tint;         ///< what the base's light is multiplied by; of coloured scenes only
    Rows<3> filter_axis;  ///< of filter sheets only

    LevelLight light;

    // The events that link a ray to the next ones, two ways on at most; the second way of ray i stands at i + most_rays.
    // Light from there meets `event`, then is turned into this ray's frame.
    using Ways = std::array<float, 2 * most_rays>;
    Ways turn_cos, turn_sin;
    std::array<Ways, 18> event;  ///< six elements of a PlanarMueller for each band

    /// Whether gloss at entry i is read from the bins, for no ray goes on from there.
    bool ends_in_bins(std::uint32_t i) const {
        return rough_events[i] >= most_rough_events || sharp_events[i] >= most_sharp_events;
    }

    template <class Real>
    void set_event(std::size_t band, std::size_t way, const PlanarMueller<Real>& m) {
        const std::array<Real, 6> elements = {m.m00, m.m01, m.m10, m.m11, m.c, m.d};
        for (std::size_t k = 0; k < 6; ++k) store(elements[k], &event[6 * band + k][way]);
    }
};

}  // namespace brewster
