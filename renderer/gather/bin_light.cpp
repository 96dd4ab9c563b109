#include "gather/bin_light.h"

#include <algorithm>

#include "bins/direction_map.h"
#include "bins/lookup.h"

namespace brewster {
namespace {

/// Of all that enters there. Young bins err everywhere: where they hardly err by more, rays had to take the place of all.
float tolerated_error(const Snapshot& bins, float tolerance) {
    return std::max(tolerance, 1.2f * static_cast<float>(bins.relative_error));
}

float band_sum(const glm::vec3& bands) {
    return bands.x + bands.y + bands.z;
}

/// Polarized world, then unpolarized.
using BothWorlds = std::array<lookup::BinValue, 2>;

BothWorlds read_both(const Snapshot& bins, const Level& level, std::uint32_t i, std::uint32_t root, std::uint32_t on,
                     std::uint32_t off) {
    return {lookup::look_up(bins, root, on, level.u[i], level.v[i]),
            lookup::look_up(bins, root, off, level.u[i], level.v[i])};
}
BothWorlds read_direct(const Snapshot& bins, const Level& level, std::uint32_t i) {
    const std::uint32_t root = bins.charts[level.chart[i]].direct_root;
    return read_both(bins, level, i, root, bins.direct_offset(0), bins.direct_offset(1));
}
BothWorlds read_indirect(const Snapshot& bins, const Level& level, std::uint32_t i) {
    const std::uint32_t root = bins.charts[level.chart[i]].indirect_root;
    return read_both(bins, level, i, root, bins.indirect_offset(0), bins.indirect_offset(1));
}

/// Light of independent errors; none of it where the pointer is null.
void put(const BothWorlds* indirect, const BothWorlds* direct, std::uint32_t i, Entered& entered) {
    for (std::size_t world = 0; world < 2; ++world) {
        glm::vec3 value(0.0f), variance(0.0f);
        for (const BothWorlds* part : {indirect, direct}) {
            if (!part) continue;
            const lookup::BinValue& read = (*part)[world];
            value += read.value;
            variance += read.standard_error * read.standard_error;
        }
        for (int band = 0; band < band_count; ++band) {
            const auto b = static_cast<std::size_t>(band);
            entered.value[world][b][i] = value[band];
            entered.error[world][b][i] = std::sqrt(variance[band]);
        }
    }
}

}  // namespace

void read_all_entered(const Snapshot& bins, const Level& level, std::uint32_t first, std::uint32_t end,
                      Entered& entered) {
    for (std::uint32_t i = first; i < end; ++i) {
        const BothWorlds indirect = read_indirect(bins, level, i), direct = read_direct(bins, level, i);
        put(&indirect, &direct, i, entered);
    }
}

void read_entered(const Snapshot& bins, std::uint32_t first, std::uint32_t end, Level& level, Entered& entered) {
    for (std::uint32_t i = first; i < end; ++i) {
        const float most_error = tolerated_error(bins, level.tolerance[i]);
        const BothWorlds indirect = read_indirect(bins, level, i);
        const float light = band_sum(indirect[0].value);
        if (level.reads_direct[i] > 0) {
            const BothWorlds direct = read_direct(bins, level, i);
            const bool errs = band_sum(direct[0].standard_error) > most_error * (light + band_sum(direct[0].value));
            if (errs) level.reads_direct[i] = 0;
            level.gathers[i] = 0;
            put(&indirect, level.reads_direct[i] > 0 ? &direct : nullptr, i, entered);
        } else {
            const float error = band_sum(indirect[0].standard_error);
            const bool errs = error > most_error * light &&
                              error > most_error * (light + band_sum(read_direct(bins, level, i)[0].value));
            level.gathers[i] = level.gathers[i] != 0 && errs ? 1 : 0;
            put(level.gathers[i] == 0 ? &indirect : nullptr, nullptr, i, entered);
        }
    }
}

template <int components>
void add_gloss_of_bins(const Scene& scene, const Snapshot& bins, const Level& level, LevelLight& light,
                       std::uint32_t i) {
    const std::uint32_t index = level.chart[i];
    if (index >= bins.gloss.roots.size() || bins.gloss.roots[index] == no_root) return;
    const Chart& chart = scene.charts[index];
    const Vector<float> outwards = -load_vector<float>(level.direction, i);
    const Vector<float> normal = load_vector<float>(level.shading_normal, i);
    if (!(dot(outwards, normal) > 0)) return;
    const Vector<float> mean_normal = eye_vector(chart.normal);
    const Vector<float> tangent_u = transported_axis(mean_normal, eye_vector(chart.axis_u), normal);
    const Vector<float> tangent_v = transported_axis(mean_normal, eye_vector(chart.axis_v), normal);
    const glm::vec2 square = direction_map::direction_square({dot(outwards, tangent_u), dot(outwards, tangent_v)});
    const auto read = [&](bool unpolarized) {
        return lookup::look_up_gloss(bins, bins.gloss.roots[index], bins.gloss.components, unpolarized, level.u[i],
                                     level.v[i], chart_fixed_point(square.x), chart_fixed_point(square.y));
    };
    const lookup::GlossValue on = read(false);
    const lookup::GlossValue off = components > 1 ? read(true) : on;
    const FrameRotation<float> turn =
        rotation_between(outwards, transported_axis(normal, tangent_u, outwards), load_vector<float>(level.axis, i));
    for (int band = 0; band < band_count; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const auto turned = rotate(turn, stokes_of<components>(on.s0[band], on.s1[band], on.s2[band], on.s3[band]));
        for (std::size_t j = 0; j < components; ++j) light.stokes[3 * j + b][i] += turned[static_cast<int>(j)];
        light.unpolarized[b][i] += off.s0[band];
        light.error[b][i] = std::hypot(light.error[b][i], on.standard_error[band]);
        light.polarized_error[b][i] = std::hypot(light.polarized_error[b][i], on.standard_error[band]);
        light.unpolarized_error[b][i] = std::hypot(light.unpolarized_error[b][i], off.standard_error[band]);
        light.coarse[i] += off.s0[band] / band_count;
    }
}

template void add_gloss_of_bins<1>(const Scene&, const Snapshot&, const Level&, LevelLight&, std::uint32_t);
template void add_gloss_of_bins<4>(const Scene&, const Snapshot&, const Level&, LevelLight&, std::uint32_t);

}  // namespace brewster
