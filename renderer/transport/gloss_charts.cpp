#include "transport/gloss_charts.h"

namespace brewster {

std::vector<Outline> GlossCharts::outlines(const std::vector<Outline>& of_scene) const {
    std::vector<Outline> chosen;
    for (std::uint32_t i = 0; i < count(); ++i) {
        chosen.push_back(of_scene[charts[i]]);
        if (coarse[i]) chosen.back().least_cell = coarse_cell;
    }
    return chosen;
}

GlossCharts gloss_charts_of(const Scene& scene, const std::vector<PreparedMaterial>& materials) {
    GlossCharts gloss;
    gloss.index.assign(scene.charts.size(), no_chart);
    for (std::uint32_t chart = 0; chart < scene.charts.size(); ++chart) {
        const PreparedMaterial& material = materials[scene.charts[chart].material];
        if (!material.reflects() || material.base == Base::transparent) continue;
        gloss.index[chart] = gloss.count();
        gloss.charts.push_back(chart);
        gloss.coarse.push_back(!material.rough() || material.slope < least_fine_slope);
    }
    return gloss;
}

}  // namespace brewster
