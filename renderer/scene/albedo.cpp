#include "scene/albedo.h"

namespace brewster {
namespace {

const Material& material_of(const Scene& scene, std::uint32_t triangle) {
    return scene.materials[scene.charts[scene.triangles[triangle].front_chart].material];
}

bool has_coloured_base(const Material& material) {
    return material.base == Base::lambert || material.base == Base::polarized_diffuse;
}

}  // namespace

glm::vec4 tint_at(const Scene& scene, std::uint32_t triangle, float b1, float b2) {
    const Material& material = material_of(scene, triangle);
    const auto& [v0, v1, v2] = scene.triangles[triangle].vertices;
    const float b0 = 1.0f - b1 - b2;
    glm::vec4 tint(1.0f);
    if (!scene.vertex_colors.empty())
        tint = b0 * scene.vertex_colors[v0] + b1 * scene.vertex_colors[v1] + b2 * scene.vertex_colors[v2];
    if (material.texture != no_texture) {
        const glm::vec2 place = b0 * scene.texture_coordinates[v0] + b1 * scene.texture_coordinates[v1] +
                                b2 * scene.texture_coordinates[v2];
        tint *= texture_at(scene.textures[material.texture], place);
    }
    return tint;
}

glm::vec3 albedo_at(const Scene& scene, const Hit& hit) {
    const Material& material = material_of(scene, hit.triangle);
    if (!has_coloured_base(material) || (material.texture == no_texture && scene.vertex_colors.empty()))
        return material.albedo;
    return material.albedo * glm::vec3(tint_at(scene, hit.triangle, hit.b1, hit.b2));
}

bool is_hole(const Scene& scene, std::uint32_t triangle, float b1, float b2) {
    const Material& material = material_of(scene, triangle);
    return material.alpha_cutoff > 0.0f && material.alpha * tint_at(scene, triangle, b1, b2).w < material.alpha_cutoff;
}

}  // namespace brewster
