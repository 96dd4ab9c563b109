#include "transport/block/groups.h"

#include <algorithm>

namespace brewster::transport {

Groups::Groups(const TransportContext& context) : of_chart(context.scene.charts.size(), 0) {
    const Scene& scene = context.scene;
    std::vector<bool> inside(scene.charts.size());
    for (std::uint32_t triangle = 0; triangle < scene.triangles.size(); ++triangle)
        if (const std::uint32_t back = scene.triangles[triangle].back_chart; back != no_chart)
            inside[back] = is_inside(context, triangle, back);
    const GlossCharts& gloss = context.bins.gloss_charts;
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart) {
        const PreparedMaterial* const material = &context.materials[scene.charts[chart].material];
        const std::uint32_t number = gloss.index[chart];
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return group.material == material && group.inside == inside[chart] && material->filter == FilterKind::none;
        });
        of_chart[chart] = static_cast<std::uint32_t>(same - groups.begin());
        if (same != groups.end()) continue;
        groups.push_back({material,
                          inside[chart],
                          number != no_chart,
                          number != no_chart && gloss.coarse[number],
                          filter_axis_of(context, chart),
                          {}});
    }
}

}  // namespace brewster::transport
