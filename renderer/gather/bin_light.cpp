#include "gather/bin_light.h"

#include "bins/direction_map.h"
#include "bins/lookup.h"

namespace brewster {

void read_entered(const Snapshot& bins, const Level& level, std::uint32_t first, std::uint32_t end,
                  DirectLight direct_light, Entered& entered) {
    for (std::uint32_t i = first; i < end; ++i) {
        const ChartBins& chart = bins.charts[level.chart[i]];
        const std::uint32_t u = level.u[i], v = level.v[i];
        for (int world = 0; world < 2; ++world) {
            const auto w = static_cast<std::size_t>(world);
            const auto indirect = lookup::look_up(bins, chart.indirect_root, bins.indirect_offset(world), u, v);
            glm::vec3 value = indirect.value, variance = indirect.standard_error * indirect.standard_error;
            if (direct_light == DirectLight::always || level.reads_direct[i] > 0) {
                const auto direct = lookup::look_up(bins, chart.direct_root, bins.direct_offset(world), u, v);
                value += direct.value;
                variance += direct.standard_error * direct.standard_error;
            }
            for (int band = 0; band < band_count; ++band) {
                const auto b = static_cast<std::size_t>(band);
                entered.value[w][b][i] = value[band];
                entered.error[w][b][i] = std::sqrt(variance[band]);
            }
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
