#pragma once
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "base/rows.h"
#include "scene/rays.h"
#include "scene/vectors.h"
#include "transport/interaction.h"

namespace brewster::transport {

/// Photons on their way, each in a slot of a few rows of floats: what a batch of lanes reads and writes with transposes.
template <int components, int bands>
struct Window {
    using Light = PhotonLight<FloatLanes, components, bands>;
    static constexpr std::size_t light_rows = (Light::numbers + row_size - 1) / row_size;
    using LightRows = std::array<Row, light_rows>;

    /// Beside the light, as the columns of a row.
    enum : std::size_t { axis_x, axis_y, axis_z, reference, photon_low, photon_high, bounce, flags };
    static constexpr std::uint32_t direct_flag = 1, useful_flag = 2;
    static constexpr int flag_bits = 2;  ///< above them stands the cell of the guide of emission

    /// One more slot than photons: lanes that are not kept are written where the next one goes.
    explicit Window(std::size_t slots) : rays(slots + 1), states(slots + 1), lights(slots + 1) {}

    std::size_t count = 0;
    std::vector<Ray> rays;
    std::vector<Row> states;
    std::vector<LightRows> lights;
};

// A ray is one row: origin, direction, the triangle it leaves, and a word whose low byte says that it meets holes.
static_assert(sizeof(Ray) == sizeof(Row) && sizeof(glm::vec3) == 3 * sizeof(float));

/// Photons of a window, in lanes; lanes beyond the last repeat it.
template <int components, int bands>
struct Batch {
    std::array<std::uint32_t, lane_count> slots;
    LaneMask present;
    Flight<FloatLanes, components, bands> flight;
    LaneMask useful;       ///< something was filed
    WordLanes guide_cell;  ///< where the photon started
};

template <int components, int bands>
Batch<components, bands> load_batch(const Window<components, bands>& window, const std::uint32_t* slots, int count) {
    using Slots = Window<components, bands>;
    Batch<components, bands> batch;
    for (int lane = 0; lane < lane_count; ++lane)
        batch.slots[static_cast<std::size_t>(lane)] = slots[lane < count ? lane : count - 1];
    batch.present = first_lanes(count);
    const auto slot_of = [&](int lane) { return batch.slots[static_cast<std::size_t>(lane)]; };
    const Columns ray =
        load_columns([&](int lane) { return reinterpret_cast<const float*>(&window.rays[slot_of(lane)]); });
    const Columns state = load_columns([&](int lane) { return window.states[slot_of(lane)].x.data(); });
    auto& flight = batch.flight;
    flight.direction = {ray[3], ray[4], ray[5]};
    flight.light.axis = {state[Slots::axis_x], state[Slots::axis_y], state[Slots::axis_z]};
    flight.reference = state[Slots::reference];
    flight.key = {words_of(state[Slots::photon_low]), words_of(state[Slots::photon_high]),
                  words_of(state[Slots::bounce])};
    const WordLanes flags = words_of(state[Slots::flags]);
    flight.alive = batch.present;
    flight.direct = equal(flags & WordLanes(Slots::direct_flag), WordLanes(Slots::direct_flag));
    batch.useful = equal(flags & WordLanes(Slots::useful_flag), WordLanes(Slots::useful_flag));
    batch.guide_cell = flags >> Slots::flag_bits;

    std::array<FloatLanes, Slots::light_rows * row_size> numbers;
    for (std::size_t row = 0; row < Slots::light_rows; ++row) {
        const Columns columns = load_columns([&](int lane) { return window.lights[slot_of(lane)][row].x.data(); });
        for (std::size_t j = 0; j < row_size; ++j) numbers[row * row_size + j] = columns[j];
    }
    std::size_t next = 0;
    for (auto& stokes : flight.light.polarized)
        for (FloatLanes& s : stokes.s) s = numbers[next++];
    for (FloatLanes& power : flight.light.unpolarized) power = numbers[next++];
    return batch;
}

/// Appends the photons of a batch that are alive, on their way from `origin` on the triangle `leaving`.
template <int components, int bands>
void append(Window<components, bands>& window, const Batch<components, bands>& batch, const Vector<FloatLanes>& origin,
            WordLanes leaving) {
    using Slots = Window<components, bands>;
    const auto& flight = batch.flight;
    const unsigned alive = bits_of(flight.alive);
    std::array<std::size_t, lane_count> place;
    for (unsigned lane = 0; lane < lane_count; ++lane)
        place[lane] = window.count + static_cast<std::size_t>(std::popcount(alive & ((1u << lane) - 1)));
    window.count += static_cast<std::size_t>(std::popcount(alive));
    const auto place_of = [&](int lane) { return place[static_cast<std::size_t>(lane)]; };

    const FloatLanes holes = floats_of(WordLanes(1u));
    store_columns({origin.x, origin.y, origin.z, flight.direction.x, flight.direction.y, flight.direction.z,
                   floats_of(leaving), holes},
                  [&](int lane) { return reinterpret_cast<float*>(&window.rays[place_of(lane)]); });
    const WordLanes none(0u);
    const WordLanes flags = select(flight.direct, WordLanes(Slots::direct_flag), none) |
                            select(batch.useful, WordLanes(Slots::useful_flag), none) |
                            (batch.guide_cell << Slots::flag_bits);
    store_columns({flight.light.axis.x, flight.light.axis.y, flight.light.axis.z, flight.reference,
                   floats_of(flight.key.photon_low), floats_of(flight.key.photon_high),
                   floats_of(flight.key.bounce + WordLanes(1u)), floats_of(flags)},
                  [&](int lane) { return window.states[place_of(lane)].x.data(); });

    std::array<FloatLanes, Slots::light_rows * row_size> numbers{};
    std::size_t next = 0;
    for (const auto& stokes : flight.light.polarized)
        for (const FloatLanes& s : stokes.s) numbers[next++] = s;
    for (const FloatLanes& power : flight.light.unpolarized) numbers[next++] = power;
    for (std::size_t row = 0; row < Slots::light_rows; ++row) {
        Columns columns;
        for (std::size_t j = 0; j < row_size; ++j) columns[j] = numbers[row * row_size + j];
        store_columns(columns, [&](int lane) { return window.lights[place_of(lane)][row].x.data(); });
    }
}

}  // namespace brewster::transport
