#pragma once
#include <cmath>
#include <vector>

#include "bins/lookup.h"
#include "scene/scene.h"

namespace brewster {

/// What enters bases, mean of the bands, at points that stand for equal areas of their chart. Of charts that fill their
/// rectangle.
struct BinLight {
    std::vector<double> values, areas;
};

inline BinLight light_of(const Scene& scene, const Snapshot& bins) {
    constexpr std::uint32_t side = 32, step = BREWSTER_UV_ONE / side;
    BinLight light;
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart) {
        const Chart& at = scene.charts[chart];
        if (at.area < 0.999f * at.size_u * at.size_v) continue;
        for (std::uint32_t i = 0; i < side * side; ++i) {
            double sum = 0;
            for (const std::uint32_t root : {bins.charts[chart].direct_root, bins.charts[chart].indirect_root}) {
                const auto found =
                    lookup::look_up(bins, root, 0u, i % side * step + step / 2, i / side * step + step / 2);
                for (int band = 0; band < 3; ++band) sum += static_cast<double>(found.value[band]) / 3;
            }
            light.values.push_back(sum);
            light.areas.push_back(static_cast<double>(at.area) / (side * side));
        }
    }
    return light;
}

/// Area-weighted rms of the relative difference from the truth, where there is light: what boxes stand on and what lamps
/// cover is left out, since nobody sees it and cells that it shares with the open surface tell of that only.
inline double relative_error_of(const BinLight& light, const BinLight& truth) {
    double area = 0, mean = 0, lit_area = 0, squares = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        area += truth.areas[i];
        mean += truth.areas[i] * truth.values[i];
    }
    const double least = 0.1 * mean / area;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (truth.values[i] < least) continue;
        const double relative = (light.values[i] - truth.values[i]) / truth.values[i];
        lit_area += truth.areas[i];
        squares += truth.areas[i] * relative * relative;
    }
    return std::sqrt(squares / lit_area);
}

}  // namespace brewster
