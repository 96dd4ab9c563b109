#pragma once
#include <cstdint>
#include <vector>

#include "bins/outline.h"
#include "scene/prepared_material.h"
#include "scene/scene.h"

namespace brewster {

/// The charts whose gloss is filed over position and direction, numbered as the tree of their bins numbers them.
struct GlossCharts {
    std::vector<std::uint32_t> index;   ///< per chart of the scene: its number, or no_chart
    std::vector<std::uint32_t> charts;  ///< per number: the chart
    std::vector<bool> coarse;           ///< per number: its lobe is too narrow for fine cells

    std::uint32_t count() const { return static_cast<std::uint32_t>(charts.size()); }

    /// Of these charts alone, from those of the whole scene; coarse ones have large cells.
    std::vector<Outline> outlines(const std::vector<Outline>& of_scene) const;
};

inline constexpr std::uint32_t coarse_cell = 1u << 19;  // fixed-point: a 32nd of a chart

/// All charts that reflect, but the transparent. `materials`: those of the scene, prepared.
GlossCharts gloss_charts_of(const Scene& scene, const std::vector<PreparedMaterial>& materials);

}  // namespace brewster
