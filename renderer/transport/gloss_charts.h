#pragma once
#include <cstdint>
#include <vector>

#include "scene/prepared_material.h"
#include "scene/scene.h"

namespace brewster {

/// The charts whose gloss is filed over position and direction, numbered as the tree of their bins numbers them.
struct GlossCharts {
    std::vector<std::uint32_t> index;   ///< per chart of the scene: its number, or no_chart
    std::vector<std::uint32_t> charts;  ///< per number: the chart

    std::uint32_t count() const { return static_cast<std::uint32_t>(charts.size()); }
};

/// Gloss of a smaller slope m is too narrow for bins: they would need more cells than there are photons.
inline constexpr float least_filed_slope = 0.0999f;

/// All charts whose interface is rough enough. `materials`: those of the scene, prepared.
GlossCharts gloss_charts_of(const Scene& scene, const std::vector<PreparedMaterial>& materials);

}  // namespace brewster
