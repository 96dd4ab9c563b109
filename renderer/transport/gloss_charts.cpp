#include "transport/gloss_charts.h"

namespace brewster {

GlossCharts gloss_charts_of(const Scene& scene, const std::vector<PreparedMaterial>& materials) {
    GlossCharts gloss;
    gloss.index.assign(scene.charts.size(), no_chart);
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart) {
        const PreparedMaterial& material = materials[scene.charts[chart].material];
        if (!material.reflects() || !material.rough() || material.slope < least_filed_slope) continue;
        gloss.index[chart] = gloss.count();
        gloss.charts.push_back(chart);
    }
    return gloss;
}

}  // namespace brewster
